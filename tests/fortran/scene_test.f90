!> The Fortran module against the C interface: values, errors, life of the handles.
program scene_test
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
  use, intrinsic :: iso_fortran_env, only: error_unit, real64
  use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
  use wrcontact
  implicit none

  !> Sums over a few thousand elements, and the balance of the load, but for rounding.
  real(real64), parameter :: rounding = 1.0e-9_real64
  integer :: failures = 0

  interface
    function solve_by_c(lateral, values) bind(C) result(status)
      import :: c_double, c_int32_t
      real(c_double), value :: lateral
      real(c_double), intent(out) :: values(4)
      integer(c_int32_t) :: status
    end function solve_by_c
  end interface

  call results_equal_those_of_c()
  call fields_add_up()
  call values_of_every_type_are_set()
  call failures_have_status_and_text()
  call assigned_scenes_are_one()
  call not_converged_has_results()
  if (failures > 0) error stop 'scene_test failed'

contains

  subroutine expect(condition, what)
    logical, intent(in) :: condition
    character(*), intent(in) :: what
    if (condition) return
    failures = failures + 1
    write (error_unit, '(2a)') 'not so: ', what
  end subroutine expect

  logical function near(value, expected, tolerance)
    real(real64), intent(in) :: value, expected, tolerance
    near = abs(value - expected) <= tolerance*abs(expected)
  end function near

  !> The same number, bit for bit: both ways lead to the same library.
  logical function same(value, expected)
    real(real64), intent(in) :: value, expected
    same = value >= expected .and. value <= expected
  end function same

  subroutine set_small_grid(scene)
    type(contact_scene), intent(in) :: scene
    call scene%set('solve.grid', [24.0_real64, 20.0_real64])
  end subroutine set_small_grid

  subroutine results_equal_those_of_c()
    type(contact_scene) :: scene
    real(real64) :: expected(4)
    call expect(solve_by_c(3.0_real64, expected) == wrc_ok, 'C solves')
    call scene%create()
    call scene%set('pose.lateral', 3.0_real64)
    call scene%solve()
    call expect(same(scene%number('left.pmax'), expected(1)), 'left.pmax as by C')
    call expect(same(scene%number('right.pmax'), expected(2)), 'right.pmax as by C')
    call expect(same(scene%number('left.approach'), expected(3)), 'left.approach as by C')
    call expect(same(scene%number('roll'), expected(4)), 'roll as by C')
    call expect(near(scene%number('left.vertical_force'), 80.0e3_real64, rounding), 'load is met')
    call expect(scene%number('left.pmax') > scene%number('right.pmax'), 'the flange side is sharper')
    call expect(scene%text('units') == 'mm, N, MPa, rad', 'units')
    call expect(len(scene%text('model')) == len_trim(scene%text('model')), 'texts have no blanks')
    call expect(len(library_version()) >= 5, 'a version')
  end subroutine results_equal_those_of_c

  subroutine fields_add_up()
    type(contact_scene) :: scene
    real(real64), allocatable :: pressure(:)
    real(real64) :: force
    call scene%create()
    call scene%set('pose.lateral', 3.0_real64)
    call scene%solve()
    pressure = scene%field('left.pressure')
    call expect(size(pressure) == nint(scene%number('left.grid.lateral'))*nint(scene%number('left.grid.longitudinal')), &
      'a value an element')
    force = sum(pressure)*scene%number('left.element_size.lateral')*scene%number('left.element_size.longitudinal')
    call expect(near(force, scene%number('left.normal_force'), 1.0e-4_real64), 'pressures add up')
    call expect(same(maxval(pressure), scene%number('left.pmax_element')), 'largest pressure')
    call expect(all(pressure >= 0.0_real64), 'no tension')
  end subroutine fields_add_up

  subroutine values_of_every_type_are_set()
    type(contact_scene) :: scene
    real(real64) :: spread_out(4)
    call scene%create()
    spread_out = [32.0_real64, -1.0_real64, 16.0_real64, -1.0_real64]
    call scene%set('solve.grid', spread_out(1:3:2))
    call scene%set('solve.side  ', 'right ')
    call scene%set('load.right', 50.0e3_real64)
    call scene%solve()
    call expect(nint(scene%number('right.grid.lateral')) == 32, 'first of a slice')
    call expect(nint(scene%number('right.grid.longitudinal')) == 16, 'second of a slice')
    call expect(near(scene%number('right.vertical_force'), 50.0e3_real64, rounding), 'load is set')
  end subroutine values_of_every_type_are_set

  subroutine failures_have_status_and_text()
    type(contact_scene) :: scene
    integer :: stat
    character(120) :: errmsg
    character(8) :: short
    real(real64) :: value
    real(real64), allocatable :: values(:)
    character(:), allocatable :: text

    errmsg = 'untouched'
    call scene%set('pose.lateral', 1.0_real64, stat, errmsg)
    call expect(stat == wrc_invalid_argument, 'no handle yet')
    call expect(index(errmsg, 'NULL') > 0, 'text without a handle')
    errmsg = 'untouched'
    call scene%create(stat, errmsg)
    call expect(stat == wrc_ok .and. errmsg == 'untouched', 'success touches no text')
    value = scene%number('roll', stat, errmsg)
    call expect(stat == wrc_no_result .and. ieee_is_nan(value), 'no number before solving')
    text = scene%text('model', stat)
    call expect(stat == wrc_no_result .and. len(text) == 0, 'no text before solving')
    values = scene%field('left.x', stat)
    call expect(stat == wrc_no_result .and. size(values) == 0, 'no field before solving')
    call scene%set('pose.sideways', 1.0_real64, stat, errmsg)
    call expect(stat == wrc_unknown_name, 'unknown key')
    call expect(index(errmsg, 'pose.sideways') > 0, 'text names the key')
    call scene%set('pose.lateral', 'far', stat, errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, '"far"') > 0, 'wrong type')
    call scene%set('solve.grid', [1.5_real64, 2.0_real64], stat, short)
    call expect(stat == wrc_invalid_argument .and. short == 'solve.gr', 'text is cut to fit')
    call scene%set('pose.lateral', 100.0_real64)
    call scene%solve(stat)
    call expect(stat == wrc_no_contact, 'no contact')
    call scene%set('track.rail', 'nowhere.txt')
    call scene%solve(stat, errmsg)
    call expect(stat == wrc_unknown_name .and. index(errmsg, 'nowhere.txt') > 0, 'no such rail')
  end subroutine failures_have_status_and_text

  subroutine assigned_scenes_are_one()
    type(contact_scene) :: scene, other
    type(contact_scene) :: scenes(3)
    type(contact_scene), allocatable :: list(:)
    integer :: i
    call scene%create()
    call set_small_grid(scene)
    call other%create()
    other = scene
    scene = scene
    call other%set('load.both', 60.0e3_real64)
    call scene%solve()
    call expect(near(other%number('left.vertical_force'), 60.0e3_real64, rounding), 'one scene')
    call scene%create()
    call expect(near(other%number('left.vertical_force'), 60.0e3_real64, rounding), &
      'the other lives on')
    do i = 1, size(scenes)
      call scenes(i)%create()
      call set_small_grid(scenes(i))
      call scenes(i)%set('pose.lateral', real(i, real64))
      call scenes(i)%solve()
    end do
    allocate (list(size(scenes)))
    list = scenes
    do i = 1, size(scenes)
      call expect(same(list(i)%number('left.pmax'), scenes(i)%number('left.pmax')), 'an array')
    end do
    scenes = other
    deallocate (list)
    call expect(near(scenes(3)%number('left.vertical_force'), 60.0e3_real64, rounding), &
      'a scalar to an array')
  end subroutine assigned_scenes_are_one

  subroutine not_converged_has_results()
    type(contact_scene) :: scene
    integer :: stat
    call scene%create()
    call scene%set('solve.side', 'left')
    call scene%set('solve.grid', [256.0_real64, 128.0_real64])
    ! Below what rounding permits on this grid.
    call scene%set('solve.method', 'paper')
    call scene%set('solve.tolerance', 1.0e-13_real64)
    call scene%solve(stat)
    call expect(stat == wrc_not_converged, 'not converged')
    call expect(scene%text('left.stop_reason') == 'stagnation', 'the reason')
    call expect(scene%number('left.pmax') > 800.0_real64, 'results all the same')
  end subroutine not_converged_has_results

end program scene_test
