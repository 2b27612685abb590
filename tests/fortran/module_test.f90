!> A lock that counts: 1 for each time it is taken, 1000 for each time it is given back.
module counted_lock
  use, intrinsic :: iso_c_binding, only: c_f_pointer, c_int, c_ptr
  implicit none
contains

  subroutine count_lock(context) bind(C)
    type(c_ptr), value :: context
    integer(c_int), pointer :: locked
    call c_f_pointer(context, locked)
    locked = locked + 1_c_int
  end subroutine count_lock

  subroutine count_unlock(context) bind(C)
    type(c_ptr), value :: context
    integer(c_int), pointer :: locked
    call c_f_pointer(context, locked)
    locked = locked + 1000_c_int
  end subroutine count_unlock

end module counted_lock

!> Everything the Fortran module offers besides a single scene (scene_test.f90) and namelists
!> (namelist_test.f90): keys, convention, names of results, fields of rank 2, profiles, solvers,
!> batches, normal and rolling contact (grid_contacts.inc), the library.
program module_test
  use, intrinsic :: iso_c_binding, only: c_funloc, c_funptr, c_int, c_loc, c_null_funptr, c_null_ptr, c_ptr
  use, intrinsic :: iso_fortran_env, only: real64
  use wrcontact
  use expectations, only: expect, finish, is_nan, near, same
  use counted_lock, only: count_lock, count_unlock
  implicit none

  !> Sums over a few thousand elements, and conversions of units, but for rounding.
  real(real64), parameter :: rounding = 1.0e-9_real64
  !> Hertz by 64 x 64 elements with 45 across the contact: 0.15/45^2 for pmax, 0.08/45^2 for the
  !> approach (docs/evidence/validation.md), twice that to be safe.
  real(real64), parameter :: hertz_pmax = 1.5e-4_real64, hertz_approach = 8.0e-5_real64
  real(real64), parameter :: pi = acos(-1.0_real64)

  call keys_have_values()
  call convention_is_of_the_scene()
  call results_are_named()
  call numbers_have_ids()
  call fields_have_two_ranks()
  call profiles_are_read_and_written()
  call points_make_a_profile()
  call solver_agrees_with_scene()
  call batch_is_each_scene()
  call sphere_is_hertzian()
  call distance_is_checked_for_its_shape()
  call rolling_contact_has_forces()
  call steps_of_rolling_have_a_history()
  call written_scene_is_there()
  call the_library_tells_of_itself()
  call handles_without_create_are_refused()
  call finish()

contains

  subroutine small(scene)
    type(contact_scene), intent(inout) :: scene
    call scene%create()
    call scene%set('solve.grid', [24, 20])
    call scene%set('pose.lateral', 2)
  end subroutine small

  subroutine keys_have_values()
    type(contact_scene) :: scene
    integer :: stat
    character(200) :: errmsg
    real(real64), allocatable :: grid(:)
    character(:), allocatable :: word
    call scene%create()
    call expect(same(scene%get_number('track.gauge'), 1435.0_real64), 'a default')
    call expect(scene%get_text('pose.roll') == 'solve', 'a word')
    call expect(is_nan(scene%get_number('pose.roll', stat)), 'a word is no number')
    call expect(stat == wrc_invalid_argument, 'and says so')
    word = scene%get_text('track.gauge', stat)
    call expect(stat == wrc_invalid_argument .and. len(word) == 0, 'a number is no word')
    call scene%set('solve.grid', [32, 16])
    grid = scene%get_numbers('solve.grid')
    call expect(size(grid) == 2, 'a list')
    call expect(all(nint(grid) == [32, 16]), 'of numbers')
    grid = scene%get_numbers('solve.gird', stat, errmsg)
    call expect(stat == wrc_unknown_name .and. size(grid) == 0, 'a key that is not there')
    call expect(index(errmsg, 'solve.gird') > 0, 'is named')
  end subroutine keys_have_values

  subroutine convention_is_of_the_scene()
    type(contact_scene) :: scene
    call scene%create()
    call scene%set('convention.units', 'SI')
    call scene%set('convention.frame', 'right-down')
    call expect(near(scene%get_number('track.gauge'), 1.435_real64, rounding), 'metres')
    call scene%set('pose.lateral', -0.003_real64)
    call scene%set('convention.units', 'mm')
    call scene%set('convention.frame', 'left-up')
    call expect(near(scene%get_number('pose.lateral'), 3.0_real64, rounding), 'to the left, in mm')
  end subroutine convention_is_of_the_scene

  subroutine results_are_named()
    type(contact_scene) :: scene
    integer :: i, found
    character(:), allocatable :: name
    call small(scene)
    call expect(.not. scene%has_number('left.pmax'), 'no result yet')
    call scene%solve()
    call expect(scene%has_number('left.pmax'), 'a result')
    call expect(.not. scene%has_number('left.patches.7.pmax'), 'no such patch')
    found = 0
    do i = 1, scene%number_count()
      name = scene%number_name(i)
      if (name == 'left.pmax') found = found + 1
      call expect(scene%has_number(name), name//' can be read')
    end do
    call expect(found == 1, 'left.pmax is named once')
    call expect(len(scene%number_name(scene%number_count() + 1)) == 0, 'past the end')
    call expect(len(scene%number_name(0)) == 0, 'before the first')
    call expect(len(result_name(1)) > 0, 'the first of all results')
    call expect(len(result_name(0)) == 0, 'before all results')
    call expect(len(result_name(100000)) == 0, 'past all results')
    found = 0
    do i = 1, scene%text_count()
      if (scene%text_name(i) == 'units') found = found + 1
    end do
    call expect(found == 1, 'units is named once')
    call expect(len(scene%text_name(scene%text_count() + 1)) == 0, 'past the last text')
  end subroutine results_are_named

  subroutine numbers_have_ids()
    type(contact_scene) :: scene, other
    integer :: keys(2), names(3), stat
    real(real64) :: values(3), spread_out(5)
    character(200) :: errmsg
    call small(scene)
    keys = [scene%key_id('pose.lateral'), scene%key_id('load.both')]
    names = [scene%number_id('left.vertical_force'), scene%number_id('left.patches.5.pmax'), &
      scene%number_id('roll')]
    call scene%numbers_by_id(names, values, stat)
    call expect(stat == wrc_no_result .and. all(is_nan(values)), 'nothing yet')
    call small(other)
    call other%set_numbers_by_id(keys, [1.0_real64, 5.0e4_real64])
    call expect(same(other%get_number('pose.lateral'), 1.0_real64), 'ids of another scene')
    call other%solve()
    call other%numbers_by_id(names, values, stat)
    call expect(stat == wrc_ok, 'read')
    call expect(same(values(1), other%number('left.vertical_force')), 'a result')
    call expect(is_nan(values(2)), 'no such patch')
    call expect(other%number_unit('left.patches.5.pmax') == 'MPa', 'but its unit')
    call expect(other%key_unit('Motion.speed') == 'mm/s', 'of a key')
    call expect(other%key_unit('track.rail') == '', 'of a key with a text')
    call expect(len(other%number_unit('left.colour', stat)) == 0 .and. stat == wrc_unknown_name, 'nor that')
    call expect(same(values(3), other%number('roll')), 'the last result')
    spread_out = -1.0_real64
    call other%numbers_by_id(names(3:1:-1), spread_out(1:5:2))
    call expect(all(same(spread_out(1:5:4), values(3:1:-2))), 'a slice')
    call expect(all(same(spread_out(2:4:2), -1.0_real64)), 'and nothing between')

    call other%set_numbers_by_id(keys, [2.0_real64, -1.0_real64], stat, errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'load.both = -1') > 0, 'refused')
    call expect(same(other%get_number('pose.lateral'), 1.0_real64), 'then none is set')
    call other%set_numbers_by_id(keys, values, stat, errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'length') > 0, 'three for two')
    call other%numbers_by_id(keys, values(:2), stat)
    call expect(stat == wrc_invalid_argument .and. all(is_nan(values(:2))), 'keys are no results')
    call other%numbers_by_id(names, values(:2), stat)
    call expect(stat == wrc_invalid_argument, 'two for three')
    call expect(other%key_id('pose.sideways', stat, errmsg) == -1, 'no such key')
    call expect(stat == wrc_unknown_name .and. index(errmsg, 'pose.sideways') > 0, 'and says so')
    call expect(other%number_id('left.colour', stat) == -1, 'no such result')
    call expect(stat == wrc_unknown_name, 'and says that')
  end subroutine numbers_have_ids

  subroutine fields_have_two_ranks()
    type(contact_scene) :: scene
    real(real64), allocatable :: flat(:), x(:, :), y(:, :)
    integer :: stat
    character(100) :: errmsg
    call small(scene)
    x = scene%field_2d('left.x', stat)
    call expect(stat == wrc_no_result .and. size(x) == 0, 'nothing yet')
    call scene%solve()
    x = scene%field_2d('left.x')
    y = scene%field_2d('left.patches.0.y')
    call expect(size(x, 1) == 20 .and. size(x, 2) == 24, 'longitudinal, lateral')
    call expect(all(x(2:, :) > x(:19, :)), 'x grows with the first index')
    call expect(all(y(:, 2:) > y(:, :23)), 'y grows with the second')
    flat = scene%field('left.x')
    call expect(all(same(flat, reshape(x, [480]))), 'the same field')
    x = scene%field_2d('left.rail_y', stat, errmsg)
    call expect(stat == wrc_invalid_argument .and. size(x) == 0, 'an outline has one rank')
    call expect(index(errmsg, 'left.rail_y') > 0, 'and says so')
    x = scene%field_2d('left.colour', stat)
    call expect(stat == wrc_unknown_name .and. size(x) == 0, 'no such field')
  end subroutine fields_have_two_ranks

  subroutine profiles_are_read_and_written()
    type(contact_profile) :: wheel, copy
    real(real64) :: lateral, height, angle, curvature, again
    real(real64), allocatable :: nodes(:), laterals(:), heights(:)
    character(:), allocatable :: text
    integer :: stat, kind
    character(200) :: errmsg
    call wheel%create()
    kind = wheel%kind(stat)
    call expect(kind == -1 .and. stat == wrc_no_result, 'an empty profile')
    nodes = wheel%nodes(stat)
    call expect(stat == wrc_no_result .and. size(nodes) == 0, 'has no nodes')
    call wheel%load_standard('S1003', stat, errmsg)
    call expect(stat == wrc_unknown_name .and. index(errmsg, 'S1003') > 0, 'no such profile')
    call wheel%load_standard('S1002')
    call expect(wheel%kind() == wrc_wheel, 'a wheel')
    call expect(index(wheel%text('name'), 'S1002') > 0, 'its name')
    text = wheel%text('weight', stat)
    call expect(stat == wrc_unknown_name .and. len(text) == 0, 'no such text')
    call expect(wheel%correction_count() == 0, 'nothing was corrected')
    call expect(len(wheel%correction(1)) == 0, 'past the last correction')
    call expect(wheel%warning_count() == 0, 'nothing is odd')
    call expect(len(wheel%warning(1)) == 0, 'past the last warning')
    call wheel%points(wrc_points_read, laterals, heights)
    call expect(size(laterals) == 0 .and. size(heights) == 0, 'no points of a built-in profile')
    nodes = wheel%nodes()
    call expect(size(nodes) > 10, 'nodes')
    call expect(all(nodes(2:) > nodes(:size(nodes) - 1)), 'in order')
    call expect(near(maxval(nodes) - minval(nodes), wheel%length(), rounding), 'over the length')
    call wheel%at(0.5_real64*wheel%length(), lateral, height, angle, curvature)
    call wheel%at(0.5_real64*wheel%length(), height=again)
    call expect(same(height, again), 'one coordinate alone')
    call expect(abs(lateral) < 100.0_real64 .and. abs(angle) < 1.6_real64, 'in mm and rad')
    call expect(abs(curvature) < 1.0_real64, 'curvature in 1/mm')

    call wheel%write('module_test_wheel.prw', 0.5_real64)
    call copy%create()
    call copy%load_file('module_test_wheel.prw')
    call expect(copy%kind() == wrc_wheel, 'the file tells the kind')
    ! Chords of 0.5 mm are shorter than arcs of 10 mm radius by 1e-4 of them.
    call expect(near(copy%length(), wheel%length(), 1.0e-3_real64), 'the same length')
    call wheel%write('module_test_wheel.txt', 0.5_real64)
    call copy%load_file('module_test_wheel.txt', kind=wrc_rail)
    call expect(copy%kind() == wrc_rail, 'the kind is passed on')
    call copy%load_file('not_there.prw', stat=stat, errmsg=errmsg)
    call expect(stat == wrc_file_unreadable .and. index(errmsg, 'not_there.prw') > 0, 'no file')
    call copy%load_file('module_test_wheel.prw', scale=-1.0_real64, stat=stat)
    call expect(stat == wrc_invalid_argument, 'the scale is passed on')
    call wheel%write('no/such/folder.prw', 0.5_real64, stat)
    call expect(stat == wrc_file_unreadable, 'cannot be written')
  end subroutine profiles_are_read_and_written

  !> Points of the built-in wheel and rail give their pressures.
  subroutine points_make_a_profile()
    type(contact_profile) :: profile
    type(contact_scene) :: scene
    real(real64), allocatable :: lateral(:), height(:)
    real(real64) :: expected
    integer :: stat
    character(200) :: errmsg
    call small(scene)
    call scene%solve()
    expected = scene%number('left.pmax')

    call profile%create()
    call scene%set('track.rail', profile, stat)
    call expect(stat == wrc_no_result, 'an empty profile is refused')
    call profile%load_standard('60E1')
    call sample(profile, lateral, height)
    call profile%set_points('sampled 60E1', wrc_rail, lateral, height)
    call expect(profile%kind() == wrc_rail, 'the kind given')
    call scene%set_profile('track.rail', profile)
    call scene%solve()
    ! Arcs through points 0.2 mm apart: the curvature that counts is that of the arcs to 1 %.
    call expect(near(scene%number('left.pmax'), expected, 0.02_real64), 'nearly the same pressures')
    call expect(.not. same(scene%number('left.pmax'), expected), 'of another profile')
    call scene%set('wheelset.wheel', profile, stat)
    call expect(stat == wrc_invalid_argument, 'a rail is no wheel')
    call scene%set('track.rail', '60E1')
    call scene%solve()
    call expect(same(scene%number('left.pmax'), expected), 'taken away again')
    call profile%set_points('short', wrc_rail, lateral(2:), height, stat=stat, errmsg=errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'length') > 0, 'lengths differ')
    call profile%set_points('mirrored', wrc_rail, lateral, height, mirror_lateral=.true., &
      mirror_height=.false., strict=.false., scale=1.0_real64, smoothing_wavelength=2.0_real64)
    call profile%set_points('kind', 7, lateral, height, stat=stat)
    call expect(stat == wrc_invalid_argument, 'no such kind')
  end subroutine points_make_a_profile

  subroutine sample(profile, lateral, height)
    type(contact_profile), intent(in) :: profile
    real(real64), allocatable, intent(out) :: lateral(:), height(:)
    real(real64), allocatable :: nodes(:)
    integer :: i, n
    nodes = profile%nodes()
    n = int(profile%length()/0.2_real64)
    allocate (lateral(n + 1), height(n + 1))
    do i = 0, n
      call profile%at(nodes(1) + i*profile%length()/n, lateral(i + 1), height(i + 1))
    end do
  end subroutine sample

  subroutine solver_agrees_with_scene()
    type(contact_solver) :: solver, same_solver
    type(contact_scene) :: scene, alone
    integer :: i, stat
    character(200) :: errmsg
    call solver%create()
    call same_solver%create()
    same_solver = solver
    call scene%create()
    call alone%create()
    do i = 0, 4
      call scene%set('pose.lateral', 0.2_real64*i)
      call same_solver%solve(scene)
    end do
    call alone%set('pose.lateral', 0.8_real64)
    call alone%solve()
    call expect(same(scene%number('left.pmax'), alone%number('left.pmax')), 'bit for bit')
    call solver%clear()
    call solver%solve(scene)
    call expect(same(scene%number('left.pmax'), alone%number('left.pmax')), 'all dropped')
    call scene%set('pose.lateral', 90)
    call solver%solve(scene, stat, errmsg)
    call expect(stat == wrc_no_contact .and. len_trim(errmsg) > 0, 'the text is the scene''s')
  end subroutine solver_agrees_with_scene

  subroutine batch_is_each_scene()
    type(contact_scene) :: scenes(4), alone
    integer :: statuses(4), stat, i
    character(200) :: errmsg
    do i = 1, 4
      call small(scenes(i))
      call scenes(i)%set('pose.lateral', i)
    end do
    call solve_batch(scenes, 2, statuses)
    call expect(all(statuses == wrc_ok), 'all solved')
    call small(alone)
    call alone%set('pose.lateral', 3)
    call alone%solve()
    call expect(same(scenes(3)%number('left.pmax'), alone%number('left.pmax')), 'as by itself')
    call scenes(2)%set('pose.lateral', 90)
    call solve_batch(scenes, 2, statuses, stat, errmsg)
    call expect(all(statuses == [wrc_ok, wrc_no_contact, wrc_ok, wrc_ok]), 'each its status')
    call expect(stat == wrc_no_contact .and. len_trim(errmsg) > 0, 'the first failure is told')
    call solve_batch(scenes, 0, stat=stat, errmsg=errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'threads') > 0, 'no threads')
    call solve_batch(scenes, 1, statuses(:2), stat)
    call expect(stat == wrc_too_small, 'room for each status')
  end subroutine batch_is_each_scene

  include 'grid_contacts.inc'

  subroutine written_scene_is_there()
    type(contact_scene) :: scene
    integer :: stat
    logical :: there
    call small(scene)
    call scene%write('module_test_scene.toml')
    inquire (file='module_test_scene.toml', exist=there)
    call expect(there, 'a file')
    call scene%write('no/such/folder.toml', stat)
    call expect(stat == wrc_file_unreadable, 'cannot be written')
  end subroutine written_scene_is_there

  subroutine the_library_tells_of_itself()
    integer :: stat, i, found
    integer(c_int), target :: locked
    type(c_funptr) :: lock, unlock
    character(:), allocatable :: name, default_value, allowed, meaning
    character(200) :: errmsg
    type(contact_scene) :: scene
    type(contact_solver) :: solver
    call expect(status_name(wrc_ok) == 'ok', 'ok')
    call expect(status_name(wrc_busy) /= status_name(wrc_no_result), 'names differ')
    found = 0
    do i = 1, scene_key_count()
      call scene_key(i, name, default_value, allowed, meaning)
      if (name /= 'track.gauge') cycle
      found = found + 1
      call expect(default_value == '1435.0' .and. index(allowed, '600') > 0, 'a key')
      call expect(len(meaning) > 0, 'has a meaning')
    end do
    call expect(found == 1, 'track.gauge is a key')
    call scene_key(0, stat=stat, errmsg=errmsg)
    call expect(stat == wrc_unknown_name .or. stat == wrc_invalid_argument, 'no key 0')
    call expect(len_trim(errmsg) > 0, 'and says so')
    call expect(standard_profile_name(wrc_wheel, 1) == 'S1002', 'first wheel')
    call expect(standard_profile_name(wrc_rail, 1) == '60E1', 'first rail')
    call expect(len(standard_profile_name(wrc_rail, 1000)) == 0, 'past the end')
    call save_wisdom('module_test_wisdom')
    call load_wisdom('module_test_wisdom')
    call load_wisdom('not_there', stat, errmsg)
    call expect(stat == wrc_file_unreadable .and. index(errmsg, 'not_there') > 0, 'no wisdom')
    call save_wisdom('no/such/folder', stat)
    call expect(stat == wrc_file_unreadable, 'no folder')

    locked = 0
    ! In variables: gfortran 12 puts constant addresses where the linker cannot reach them.
    lock = c_funloc(count_lock)
    unlock = c_funloc(count_unlock)
    call set_planner_lock(lock, unlock, c_loc(locked))
    call small(scene)
    call scene%set('solve.grid', [37, 23])
    call solver%create()
    call solver%set('planner', 'measure') ! the usual plans were made with the first handle
    call solver%solve(scene)
    call solver%set('planner', 'guess', stat, errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'estimate') > 0, 'no such planner')
    call expect(locked > 0 .and. locked/1000_c_int == mod(locked, 1000_c_int), 'taken and given back as often')
    call set_planner_lock(c_null_funptr, c_null_funptr, c_null_ptr)
    call set_planner_lock(lock, c_null_funptr, c_null_ptr, stat)
    call expect(stat == wrc_invalid_argument, 'half a lock')
  end subroutine the_library_tells_of_itself

  subroutine handles_without_create_are_refused()
    type(contact_scene) :: scene
    type(contact_solver) :: solver
    type(contact_profile) :: profile
    type(normal_contact) :: normal
    type(rolling_contact) :: rolling
    integer :: stat
    character(200) :: errmsg
    errmsg = ''
    call scene%solve(stat, errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'NULL') > 0, 'scene')
    call expect(scene%number_count() == 0, 'no numbers')
    call expect(scene%text_count() == 0, 'no texts')
    errmsg = ''
    call solver%solve(scene, stat, errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'NULL') > 0, 'solver')
    call solver%clear(stat=stat)
    call expect(stat == wrc_invalid_argument, 'clear')
    call profile%load_standard('S1002', stat, errmsg)
    call expect(stat == wrc_invalid_argument, 'profile')
    call normal%solve(stat, errmsg)
    call expect(stat == wrc_invalid_argument, 'normal contact')
    call normal%set_grid(4, 4, 1.0_real64, 1.0_real64, stat)
    call expect(stat == wrc_invalid_argument, 'its grid')
    call normal%set_distance([1.0_real64], stat)
    call expect(stat == wrc_invalid_argument, 'its distance')
    call rolling%solve(stat, errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'rolling = NULL') > 0, 'rolling')
    call rolling%set_grid(4, 4, 1.0_real64, 1.0_real64, stat)
    call expect(stat == wrc_invalid_argument, 'its grid')
    call rolling%set_pressure([1.0_real64], stat)
    call expect(stat == wrc_invalid_argument, 'its pressure')
    call rolling%set_slip(stat=stat)
    call expect(stat == wrc_invalid_argument, 'its slip')
    call rolling%set_previous(stat=stat)
    call expect(stat == wrc_invalid_argument, 'its history')
    call rolling%set('contact', 'shift', stat)
    call expect(stat == wrc_invalid_argument, 'its text')
    call rolling%advance(stat)
    call expect(stat == wrc_invalid_argument, 'its step')
  end subroutine handles_without_create_are_refused

end program module_test
