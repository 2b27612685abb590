!> Calls for vehicle simulations of the Fortran module.
program vehicle_test
  use, intrinsic :: iso_fortran_env, only: real64
  use wrcontact
  use expectations
  implicit none
  real(real64), parameter :: q(6) = [0.0_real64, 3.0_real64, 459.815_real64, 1.8e-4_real64, 0.0_real64, &
    1.0e-3_real64]
  real(real64), parameter :: v(6) = [2.0e4_real64, 15.0_real64, 1.0_real64, 2.0e-3_real64, &
    43.5_real64, -5.0e-3_real64]

  call steps_give_forces_patches_and_derivatives()
  call steps_of_many_wheelsets()
  call steps_take_further_arguments()
  call steps_of_time_with_histories()
  call wheelsets_in_equilibrium()
  call creep_forces_of_own_creepages()
  call tables_over_keys()
  call finish()

contains

  subroutine steps_take_further_arguments()
    type(contact_scene) :: scenes(2)
    type(contact_solver) :: solvers(2)
    real(real64) :: f(6, 2), g(6, 2, 2), dfdq(6, 6, 2), dfdv(6, 6, 2), dfdr(6, 3, 2), dfdrv(6, 3, 2)
    real(real64) :: many_r(6, 3, 2, 2), bends(2), mu(2, 2), moving(3, 2)
    integer :: stat, i
    character(200) :: errmsg
    do i = 1, 2
      call make(scenes(i))
      call solvers(i)%create()
    end do
    moving = 0
    moving(1, 1) = 3.0_real64
    call solvers(1)%step(scenes(1), q, v, f, dfdq=dfdq, dfdv=dfdv, curvature=-2.0e-6_real64, &
      friction=[0.2_real64, 0.4_real64], rail_velocities=moving, dfdr=dfdr, dfdrv=dfdrv)
    call expect(same(scenes(1)%get_number('friction.right'), 0.4_real64), 'friction of a step stays')
    call expect(same(scenes(1)%get_number('motion.curvature'), -2.0e-6_real64), 'curvature of a step')
    call expect(all(abs(dfdr(:, 2, :) + dfdq(:, 3, :)) <= 0), 'a rail that sinks is a wheel that rises')
    call expect(all(abs(dfdrv(:, 1, :) + dfdv(:, 2, :)) <= 0), 'a rail moves against the wheel')
    bends = -2.0e-6_real64
    mu(1, :) = 0.2_real64
    mu(2, :) = 0.4_real64
    call step_batch(solvers, scenes, spread(q, 2, 2), spread(v, 2, 2), g, 2, curvature=bends, friction=mu, &
      rail_velocities=spread(moving, 3, 2), dfdr=many_r)
    call expect(all(abs(g(:, :, 2) - f) <= 0) .and. all(abs(many_r(:, :, :, 2) - dfdr) <= 0), &
      'a batch has the bits of steps')
    mu(2, 2) = -1.0_real64
    call step_batch(solvers, scenes, spread(q, 2, 2), spread(v, 2, 2), g, 2, friction=mu, stat=stat, &
      errmsg=errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'wheelset 2: friction.right') == 1, &
      'the message names the wheelset')
  end subroutine steps_take_further_arguments

  subroutine steps_of_time_with_histories()
    type(contact_scene) :: scenes(2)
    type(contact_solver) :: solvers(2)
    type(contact_history) :: histories(2), other, none
    real(real64), parameter :: h = 1.0e-3_real64
    real(real64) :: f(6, 2), g(6, 2), many(6, 2, 2), slow(6), at_rest(6)
    integer :: stat, i
    character(200) :: errmsg
    do i = 1, 2
      call make(scenes(i))
      call scenes(i)%set('solve.creep', 'full')
      call solvers(i)%create()
      call histories(i)%create()
    end do
    slow = [1.0_real64, 0.5_real64, 0.0_real64, 0.0_real64, 0.0_real64, 0.0_real64]
    at_rest = 0
    call solvers(1)%step(scenes(1), q, slow, f, history=histories(1), time_step=h)
    call solvers(1)%step(scenes(1), q, slow, g, history=histories(1), time_step=h)
    call expect(all(same(f, g)), 'a step that was not accepted is repeated')
    call expect(sum(f(1, :)) < -1.0e3_real64, 'adhesion resists')
    call histories(1)%accept()
    call other%create()
    call other%copy(histories(1))
    call solvers(1)%step(scenes(1), q, at_rest, g, history=other, time_step=h)
    call expect(abs(sum(g(1, :)) - sum(f(1, :))) < 1.0e-2_real64*abs(sum(f(1, :))), &
      'and holds when the wheelset has stopped')
    call other%clear()
    call solvers(1)%step(scenes(1), q, at_rest, g, history=other, time_step=h)
    call expect(abs(sum(g(1, :))) < 1.0_real64, 'a cleared history has no tractions')
    call step_batch(solvers, scenes, spread(q, 2, 2), spread(slow, 2, 2), many, 2, &
      histories=histories, time_step=h)
    call expect(all(same(many(:, :, 2), f)), 'in a batch as alone')
    call solvers(1)%step(scenes(1), q, slow, g, stat, errmsg, history=other)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'time_step = 0') == 1, 'no step of time')
    call solvers(1)%step(scenes(1), q, slow, g, stat, errmsg, history=none, time_step=h)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'history') == 1, 'a history not created')
    call none%accept(stat)
    call expect(stat == wrc_invalid_argument, 'nor accepted')
  end subroutine steps_of_time_with_histories

  subroutine wheelsets_in_equilibrium()
    type(contact_scene) :: scene
    type(contact_solver) :: solver
    real(real64) :: place(6), f(6, 2), g(6, 2)
    integer :: stat
    call make(scene)
    call solver%create()
    place = [0.0_real64, 3.0_real64, 0.0_real64, 0.0_real64, 0.0_real64, 1.0e-3_real64]
    call solver%equilibrium(scene, wrc_load_of_axle, [1.4e5_real64, 2.0e6_real64], place, f, v)
    call expect(abs(sum(f(3, :)) - 1.4e5_real64) < 20 .and. abs(sum(f(4, :)) + 2.0e6_real64) < 2.0e4_real64, &
      'the axle carries its load and moment')
    call solver%step(scene, place, v, g)
    call expect(all(abs(f - g) <= 0), 'a step there has the same bits')
    call solver%equilibrium(scene, wrc_loads_of_wheels, [-1.0_real64, 1.0_real64], place, f, stat=stat)
    call expect(stat == wrc_invalid_argument, 'wheels cannot pull')
  end subroutine wheelsets_in_equilibrium

  subroutine make(scene)
    type(contact_scene), intent(inout) :: scene
    call scene%create()
    call scene%set('solve.accuracy', 1.0e-2_real64)
    call scene%set('solve.accuracy_of', 'forces')
    call scene%set('solve.creep', 'fastsim')
  end subroutine make

  subroutine steps_give_forces_patches_and_derivatives()
    type(contact_scene) :: scene
    type(contact_solver) :: solver, none
    type(contact_patch) :: patches(4)
    real(real64) :: f(6, 2), g(6, 2), dfdq(6, 6, 2), dfdv(6, 6, 2), moved(6), rails(3, 2)
    integer :: stat, patch_count, states(2)
    character(200) :: errmsg
    call make(scene)
    call solver%create()
    call solver%step(scene, q, v, f)
    call expect(same(f(2, 1), scene%number('left.total.force.y')), 'left lateral force')
    call expect(same(f(6, 2), scene%number('right.total.moment.z')), 'right moment about z')
    states = -1
    call solver%step(scene, q, v, g, stat, errmsg, dfdq, dfdv, patches=patches, &
      patch_count=patch_count, states=states)
    call expect(stat == wrc_ok .and. all(same(f, g)), 'derivatives change no bit')
    call expect(all(states == 0), 'no state to tell')
    call expect(same(dfdq(2, 3, 1), scene%number('left.jacobian.force.y.by.vertical')), 'by height')
    call expect(same(dfdv(1, 5, 2), scene%number('right.jacobian.force.x.by.pitch_rate')), 'by pitch')
    call expect(patch_count == 2, 'two patches')
    call expect(same(patches(2)%wheel, 1.0_real64), 'the second on the right')
    call expect(same(patches(1)%friction_power, scene%number('left.patches.0.friction_power')), &
      'the last member')
    call solver%step(scene, q, v, g, stat, errmsg, patches=patches(:1), patch_count=patch_count)
    call expect(stat == wrc_too_small .and. patch_count == 2, 'no room for both')
    rails = 0
    rails(1, 2) = -0.5_real64
    call solver%step(scene, q, v, g, rails=rails)
    call expect(same(g(3, 1), f(3, 1)) .and. .not. same(g(2, 2), f(2, 2)), 'the right rail moved')
    moved = q
    moved(3) = 470
    call solver%step(scene, moved, v, g, patch_count=patch_count, states=states)
    call expect(all(same(g, 0.0_real64)) .and. all(states == wrc_lifted) .and. patch_count == 0, &
      'lifted')
    moved(6) = 1
    g = f
    call solver%step(scene, moved, v, g, stat, errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'pose.yaw = 1') == 1, 'refused')
    call expect(all(same(g, f)), 'and left as it was')
    call none%step(scene, q, v, g, stat)
    call expect(stat == wrc_invalid_argument, 'without a solver')
    call scene%solve()
    call scene%patches(patches, patch_count)
    call expect(patch_count == 0, 'still lifted')
  end subroutine steps_give_forces_patches_and_derivatives

  subroutine steps_of_many_wheelsets()
    integer, parameter :: n = 3
    type(contact_scene) :: scenes(n), alone
    type(contact_solver) :: solvers(n), solver
    real(real64) :: qs(6, n), vs(6, n), f(6, 2, n), g(6, 2), dfdq(6, 6, 2, n), dfdq1(6, 6, 2)
    integer :: i, statuses(n), states(2, n), stat
    character(200) :: errmsg
    do i = 1, n
      call make(scenes(i))
      call solvers(i)%create()
      qs(:, i) = q
      qs(2, i) = 3 + 0.01_real64*i
      vs(:, i) = v
    end do
    call step_batch(solvers, scenes, qs, vs, f, 2, statuses, dfdq=dfdq, states=states)
    call expect(all(statuses == wrc_ok) .and. all(states == 0), 'all of them')
    call make(alone)
    call solver%create()
    do i = 1, n
      call solver%step(alone, qs(:, i), vs(:, i), g, dfdq=dfdq1)
      call expect(all(same(f(:, :, i), g)), 'as by itself')
      call expect(all(same(dfdq(:, :, :, i), dfdq1)), 'and its derivatives')
    end do
    qs(6, 2) = 1
    call step_batch(solvers, scenes, qs, vs, f, 2, statuses, stat, errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'wheelset 2: pose.yaw') == 1, &
      'the second fails')
    call expect(statuses(2) == stat .and. statuses(3) == wrc_ok, 'alone')
    call step_batch(solvers(:2), scenes, qs, vs, f, 2, stat=stat, errmsg=errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'q(6, n)') > 0, 'two for three')
  end subroutine steps_of_many_wheelsets

  subroutine creep_forces_of_own_creepages()
    type(contact_scene) :: scene
    type(contact_solver) :: solver
    type(contact_patch) :: patches(4)
    real(real64) :: f(6, 2), forces(3), by(3, 3), ahead(3), creepages(3)
    integer :: patch_count, stat
    call make(scene)
    call solver%create()
    call solver%step(scene, q, v, f, patches=patches, patch_count=patch_count)
    creepages = [patches(1)%creepage_longitudinal, patches(1)%creepage_lateral, &
      patches(1)%creepage_spin]
    call solver%creep(scene, 1, creepages, forces, by_creepage=by)
    call expect(abs(forces(1) - patches(1)%creep_force_longitudinal) <= 1.0e-6_real64*abs(forces(1)), &
      'those of the step')
    creepages(2) = creepages(2) + 1.0e-5_real64
    call solver%creep(scene, 1, creepages, ahead)
    call expect(abs(ahead(2) - forces(2) - 1.0e-5_real64*by(2, 2)) < 2.0e-2_real64*abs(ahead(2) - &
      forces(2)), 'and their slope')
    call solver%creep(scene, 3, creepages, forces, stat)
    call expect(stat == wrc_invalid_argument, 'no third patch')
  end subroutine creep_forces_of_own_creepages

  subroutine tables_over_keys()
    type(contact_scene) :: scene
    real(real64), allocatable :: table(:, :)
    real(real64), parameter :: laterals(3) = [-2, 0, 3], yaws(2) = [0.0_real64, 2.0e-3_real64]
    integer :: stat
    character(200) :: errmsg
    call make(scene)
    call scene%tabulate('pose.lateral pose.yaw', [laterals, yaws], [3, 2], 'roll  left.pmax', table, &
      threads=2, path='table.txt')
    call expect(all(shape(table) == [2, 6]), 'two results of six combinations')
    call scene%set('pose.lateral', laterals(3))
    call scene%set('pose.yaw', yaws(2))
    call scene%solve()
    call expect(same(table(1, 6), scene%number('roll')), 'the last one')
    call expect(same(table(2, 6), scene%number('left.pmax')), 'and its pressure')
    call scene%tabulate('pose.lateral', laterals, [2], 'roll', table, stat=stat, errmsg=errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'counts') > 0, 'three for two')
    call expect(all(shape(table) == [2, 6]), 'and left as it was')
  end subroutine tables_over_keys

end program vehicle_test
