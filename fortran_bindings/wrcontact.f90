!> Wheel/rail contact from Fortran. Units, frame, keys and names of results as in wrcontact.h and
!> docs/results.md; docs/fortran.md shows how to use it. Example:
!>
!>     use wrcontact, only: contact_scene
!>     type(contact_scene) :: scene
!>     call scene%create()
!>     call scene%set('track.rail', '54E3')
!>     call scene%set('solve.grid', [256, 128])
!>     call scene%solve()
!>     print *, scene%number('left.pmax'), maxval(scene%field('left.pressure'))
!>
!> Errors: every procedure takes the optional arguments `stat` (one of the wrc_* constants, 0 on
!> success) and `errmsg` (the text of a failure; unchanged on success). Without `stat` a failure
!> ends the program with `error stop` and the text. wrc_not_converged counts as a failure, but with
!> `stat` the results are available. After a failure numbers are NaN, texts empty and fields of length zero.
!> Assignment: after `a = b` both refer to the same object, which is destroyed with the last of them.
!> Threads: one thread at a time for an object and all objects assigned from it.
!> Fields of rank 2 have the shape (longitudinal, lateral), the order in which the library keeps them.
!> The module ships as source (with the files it includes): .mod files belong to one compiler.
module wrcontact
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_funptr, &
    c_int32_t, c_int64_t, c_loc, c_null_char, c_null_funptr, c_null_ptr, c_ptr, c_size_t, c_sizeof
  use, intrinsic :: iso_fortran_env, only: real64
  use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
  implicit none
  private

  public :: solve_batch, step_batch, library_version, status_name, scene_key_count, scene_key
  public :: standard_profile_name, result_name, load_wisdom, save_wisdom, set_planner_lock, table_output_name

  !> Values of `stat`; those of wrc_status in wrcontact.h.
  integer, parameter, public :: wrc_ok = 0
  integer, parameter, public :: wrc_invalid_argument = 1
  integer, parameter, public :: wrc_unknown_name = 2
  integer, parameter, public :: wrc_file_unreadable = 3
  integer, parameter, public :: wrc_file_malformed = 4
  integer, parameter, public :: wrc_no_contact = 5
  integer, parameter, public :: wrc_out_of_memory = 6
  integer, parameter, public :: wrc_internal = 7
  integer, parameter, public :: wrc_not_converged = 8
  integer, parameter, public :: wrc_too_small = 9
  integer, parameter, public :: wrc_no_result = 10
  integer, parameter, public :: wrc_busy = 11
  !> Flags of a wheel's state, added up.
  integer, parameter, public :: wrc_lifted = 1
  integer, parameter, public :: wrc_on_flange_tip = 2, wrc_on_chamfer = 4
  integer, parameter, public :: wrc_beyond_yield = 8
  integer, parameter, public :: wrc_solved_exactly = 16, wrc_beyond_load = 64
  integer, parameter, public :: wrc_table_outputs = 8 !< of each wheel, by a table
  integer, parameter, public :: wrc_at_part_end = 32
  !> Values of the results grade, left.grade and right.grade.
  integer, parameter, public :: wrc_fine = 0, wrc_slightly_over = 1, wrc_do_not_use = 2
  !> Kinds of profiles.
  integer, parameter, public :: wrc_wheel = 0
  integer, parameter, public :: wrc_rail = 1
  integer, parameter, public :: wrc_loads_of_wheels = 0
  integer, parameter, public :: wrc_load_of_axle = 1
  !> Where a wheel's file has lateral 0, and which points of a profile are requested.
  integer, parameter, public :: wrc_origin_tape = 1
  integer, parameter, public :: wrc_origin_flange_back = 2
  real(real64), parameter, public :: wrc_smoothing_none = -1.0_real64
  real(real64), parameter, public :: wrc_smoothing_auto = -2.0_real64
  integer, parameter, public :: wrc_points_read = 0
  integer, parameter, public :: wrc_points_dropped = 1

  integer, parameter :: scene_kind = 1, solver_kind = 2, profile_kind = 3, normal_kind = 4, &
    rolling_kind = 5, history_kind = 6, table_kind = 7

  !> Shared by variables that were assigned to each other.
  type :: shared_handle
    type(c_ptr) :: handle = c_null_ptr
    integer :: kind = 0
    integer :: references = 0
    !> A normal or rolling contact: elements along and across the rail, and those when it was last solved; shapes of
    !> distances or pressures, slips and previous tractions, if of rank 2 (else 0).
    integer(c_int64_t) :: grid(2) = 0, solved(2) = 0, given(2) = 0, slip(2) = 0, previous(2) = 0
    !> Whether a rolling contact needs previous tractions.
    logical :: in_steps = .false.
  end type shared_handle

  !> A wheel or rail profile.
  type, public :: contact_profile
    private
    type(shared_handle), pointer :: shared => null()
  contains
    !> An empty profile; one held before is released.
    procedure :: create => profile_create
    !> load_standard(name): a built-in profile.
    procedure :: load_standard => profile_load_standard
    !> load_file(path, kind, mirror_lateral, mirror_height, strict, scale, smoothing_wavelength,
    !> origin, tape_offset, lateral_shift, slice, rotation, align_to): all arguments but the path are
    !> optional, those from origin on by keyword; see wrc_read_options in wrcontact.h.
    procedure :: load_file => profile_load_file
    !> set_points(name, kind, lateral, height) and the options of load_file.
    procedure :: set_points => profile_set_points
    !> write(path, spacing): points `spacing` mm apart along the arc.
    procedure :: write => profile_write
    !> wrc_wheel or wrc_rail; -1 after a failure.
    procedure :: kind => profile_kind_of
    !> text(name): 'name', 'title', 'source', 'confidence'.
    procedure :: text => profile_text
    procedure :: correction_count => profile_correction_count
    !> correction(i), i from 1: a correction made while reading; empty past the end.
    procedure :: correction => profile_correction
    procedure :: warning_count => profile_warning_count
    !> warning(i), i from 1: what no wheel or rail has; empty past the end.
    procedure :: warning => profile_warning
    !> points(which, lateral, height): wrc_points_read, before smoothing, or wrc_points_dropped.
    procedure :: points => profile_points
    !> load_surface(path): joins the slices of a .slcs or .slcw file; surface_line(i): what they make.
    procedure :: load_surface => profile_load_surface
    procedure :: surface_line => profile_surface_line
    !> surface_at(sheet, across, along, place, lateral, height): sheet from 1, at shares.
    procedure :: surface_at => profile_surface_at
    !> Arc length, mm.
    procedure :: length => profile_length
    !> Arc lengths of the nodes, mm.
    procedure :: nodes => profile_nodes
    !> at(arc, lateral, height, angle, curvature): the curve there; only the arc is required.
    procedure :: at => profile_at
    generic :: assignment(=) => share
    procedure, private :: share => profile_share
    ! Elemental, since a scalar finalizer skips arrays.
    final :: profile_release
  end type contact_profile

  !> The input of a scene, and its results.
  type, public :: contact_scene
    private
    type(shared_handle), pointer :: shared => null()
  contains
    !> A scene with the defaults of the paper's Table 1; an earlier one is released.
    procedure :: create => scene_create_0_4 ! as the symbol in wrcontact.h
    !> set(key, value): a real(real64), an integer, a character, a rank-1 array of numbers, or a profile.
    generic :: set => set_number, set_integer, set_text, set_numbers, set_integers, set_profile
    procedure :: set_profile => scene_set_profile
    !> read_namelist(unit) or read_namelist(path): sets what namelist groups give; see wrcontact_namelist.inc.
    generic :: read_namelist => read_unit, read_path
    !> Values of keys.
    procedure :: get_number => scene_get_number
    procedure :: get_text => scene_get_text
    procedure :: get_numbers => scene_get_numbers
    procedure :: solve => scene_solve
    !> write(path): a file that wrc_case replays.
    procedure :: write => scene_write
    !> number(name): a scalar result.
    procedure :: number => scene_number
    procedure :: has_number => scene_has_number
    !> Ids of keys and of names of results, the same for all scenes; -1 after a failure.
    procedure :: key_id => scene_key_id
    procedure :: number_id => scene_number_id
    procedure :: number_unit => scene_number_unit
    procedure :: key_unit => scene_key_unit
    !> patches(patches, patch_count): all contact patches; see wrc_scene_patches in wrcontact.h.
    procedure :: patches => scene_patches
    !> tabulate(keys, values, counts, results, table, threads, path): results over all combinations
    !> of values of keys; see wrc_scene_tabulate in wrcontact.h.
    procedure :: tabulate => scene_tabulate
    !> Numbers of many steps by id. set_numbers_by_id(ids, values): all or, if one is refused, none.
    !> numbers_by_id(ids, values): not-a-number is what the scene does not have.
    procedure :: set_numbers_by_id => scene_set_numbers_by_id
    procedure :: numbers_by_id => scene_numbers_by_id
    !> text(name): a text result.
    procedure :: text => scene_text
    !> field(name): a field of a patch ('left.patches.1.pressure'; 'left.pressure' is that of patch
    !> 0), longitudinal index fastest, or an outline ('left.rail_y').
    procedure :: field => scene_field
    !> field_2d(name): a field of a patch, shaped (longitudinal, lateral).
    procedure :: field_2d => scene_field_2d
    !> Names of all available results: number_name(i), text_name(i), i from 1.
    procedure :: number_count => scene_number_count
    procedure :: number_name => scene_number_name
    !> How many warnings there are, of profiles and both wheels together.
    procedure :: warning_count => scene_warning_count
    !> warning(i), i from 1, with the profile or wheel it is of; empty past the end.
    procedure :: warning => scene_warning
    procedure :: text_count => scene_text_count
    procedure :: text_name => scene_text_name
    generic :: assignment(=) => share
    procedure, private :: set_number => scene_set_number
    procedure, private :: set_integer => scene_set_integer
    procedure, private :: set_text => scene_set_text
    procedure, private :: set_numbers => scene_set_numbers
    procedure, private :: set_integers => scene_set_integers
    procedure, private :: read_unit => scene_read_unit
    procedure, private :: read_path => scene_read_path
    procedure, private :: share => scene_share
    final :: scene_release
  end type contact_scene

  !> What is kept from one scene to the next, for vehicle simulations.
  type, public :: contact_solver
    private
    type(shared_handle), pointer :: shared => null()
  contains
    procedure :: create => solver_create
    !> set(key, value): 'planner' or 'precision'; see wrc_solver_set_text in wrcontact.h.
    procedure :: set => solver_set
    !> solve(scene): as scene%solve(), faster: it keeps profiles, tables and plans.
    procedure :: solve => solver_solve
    !> step(scene, q, v, f, stat, errmsg, dfdq, dfdv, rails, patches, patch_count, states,
    !> rail_velocities, curvature, friction, dfdr, dfdrv, history, time_step): one evaluation; positions
    !> q(6), velocities v(6) in, forces f(6, 2) of both wheels out; wrc_solver_step_with in wrcontact.h.
    procedure :: step => solver_step
    !> equilibrium(scene, kind, loads, q, f, v, ...): height and roll, q(3) and q(4), at which a
    !> wheelset carries loads(2); see wrc_solver_equilibrium in wrcontact.h. The others as in step.
    procedure :: equilibrium => solver_equilibrium
    !> creep(scene, patch, creepages, forces, stat, errmsg, by_creepage): wrc_solver_creep in wrcontact.h.
    procedure :: creep => solver_creep
    !> Drops what it keeps but its options, so that profile files are read again.
    procedure :: clear => solver_clear
    generic :: assignment(=) => share
    procedure, private :: share => solver_share
    final :: solver_release
  end type contact_solver

  !> What the contacts of a wheelset remember from one step of time to the next; see wrc_history in
  !> wrcontact.h. Variables assigned to each other share it; copy makes another one.
  type, public :: contact_history
    private
    type(shared_handle), pointer :: shared => null()
  contains
    !> One without displacements; an earlier one is released.
    procedure :: create => history_create
    !> Later steps start from the state after the last one.
    procedure :: accept => history_accept
    !> Back to no displacements.
    procedure :: clear => history_clear
    !> copy(from): takes over the state of another one.
    procedure :: copy => history_copy
    generic :: assignment(=) => share
    procedure, private :: share => history_share
    final :: history_release
  end type contact_history

  !> Contact forces of a wheelset from a table, which says how far they may be off. Variables that are
  !> assigned to each other are one handle; threads each take one of their own, by share.
  type, public :: contact_table
    private
    type(shared_handle), pointer :: shared => null()
  contains
    !> build(scene, stat, errmsg, lateral, roll, yaw, load, tolerance, fineness, threads, progress,
    !> context, resume_file): takes minutes; see wrc_table_build in wrcontact.h.
    procedure :: build => table_build
    procedure :: save => table_save
    procedure :: load => table_load
    !> share(other): `other` gets a handle of its own to the same table.
    procedure :: share => table_share
    !> line(i): what it is of, from 1; facts(known): ranges, and errors in held-out random states.
    procedure :: line => table_line
    procedure :: facts => table_get_facts
    !> step(q, v, f, error, stat, errmsg, solver, scene, dfdq, dfdv, rails, states, rail_velocities, curvature, friction,
    !> dfdr, dfdrv, likely_errors, outputs, output_errors): as step of contact_solver; errors as of wrc_table_step.
    procedure :: step => table_step
    !> equilibrium(kind, loads, q, f, v, error, ...): as that of contact_solver, with further arguments of step.
    procedure :: equilibrium => table_equilibrium
    generic :: assignment(=) => assign
    procedure, private :: assign => table_assign
    final :: table_release
  end type contact_table

  !> Normal contact of a gap given by the caller; keys and names of results in wrcontact_grid.h.
  type, public :: normal_contact
    private
    type(shared_handle), pointer :: shared => null()
  contains
    !> An empty problem; an earlier one is released.
    procedure :: create => normal_create
    !> set_grid(lateral_count, longitudinal_count, lateral_step, longitudinal_step)
    procedure :: set_grid => normal_set_grid
    !> set_distance(values): of rank 1, longitudinal index fastest, or of rank 2, shaped (longitudinal, lateral).
    generic :: set_distance => set_distance_1, set_distance_2
    !> set(key, value): a real(real64), an integer or a character.
    generic :: set => set_number, set_integer, set_text
    procedure :: solve => normal_solve
    procedure :: number => normal_number
    procedure :: text => normal_text
    procedure :: field => normal_field
    procedure :: field_2d => normal_field_2d
    generic :: assignment(=) => share
    procedure, private :: set_distance_1 => normal_set_distance_1
    procedure, private :: set_distance_2 => normal_set_distance_2
    procedure, private :: set_number => normal_set_number
    procedure, private :: set_integer => normal_set_integer
    procedure, private :: set_text => normal_set_text
    procedure, private :: share => normal_share
    final :: normal_release
  end type normal_contact

  !> Tangential contact of pressures given by the caller; keys and names of results in
  !> wrcontact_grid.h.
  type, public :: rolling_contact
    private
    type(shared_handle), pointer :: shared => null()
  contains
    !> An empty problem; an earlier one is released.
    procedure :: create => rolling_create
    !> set_grid(lateral_count, longitudinal_count, lateral_step, longitudinal_step)
    procedure :: set_grid => rolling_set_grid
    !> set_pressure(values): of rank 1, longitudinal index fastest, or of rank 2, shaped
    !> (longitudinal, lateral).
    generic :: set_pressure => set_pressure_1, set_pressure_2
    !> set_slip(slip_x, slip_y): rigid slip of each element in addition to that of the creepages, of
    !> either rank; without them: there is none.
    generic :: set_slip => set_slip_1, set_slip_2
    !> set_previous(traction_x, traction_y): tractions before a step or a shift, of either rank;
    !> without them: there are none.
    generic :: set_previous => set_previous_1, set_previous_2
    !> set(key, value): a real(real64), an integer or a character.
    generic :: set => set_number, set_integer, set_text
    procedure :: solve => rolling_solve
    !> The tractions just found become the previous ones.
    procedure :: advance => rolling_advance
    procedure :: number => rolling_number
    procedure :: field => rolling_field
    procedure :: field_2d => rolling_field_2d
    generic :: assignment(=) => share
    procedure, private :: set_pressure_1 => rolling_set_pressure_1
    procedure, private :: set_pressure_2 => rolling_set_pressure_2
    procedure, private :: set_slip_1 => rolling_set_slip_1
    procedure, private :: set_slip_2 => rolling_set_slip_2
    procedure, private :: set_previous_1 => rolling_set_previous_1
    procedure, private :: set_previous_2 => rolling_set_previous_2
    procedure, private :: set_number => rolling_set_number
    procedure, private :: set_integer => rolling_set_integer
    procedure, private :: set_text => rolling_set_text
    procedure, private :: share => rolling_share
    final :: rolling_release
  end type rolling_contact

  include 'wrcontact_c.inc'

contains

  include 'wrcontact_library.inc'
  include 'wrcontact_scene.inc'
  include 'wrcontact_solver.inc'
  include 'wrcontact_vehicle.inc'
  include 'wrcontact_history.inc'
  include 'wrcontact_table.inc'
  include 'wrcontact_normal.inc'
  include 'wrcontact_rolling.inc'
  include 'wrcontact_profile.inc'
  include 'wrcontact_namelist.inc'

  ! ---- Handles, texts and errors ----------------------------------------------------------------

  subroutine take_new(shared, kind, stat, errmsg)
    type(shared_handle), pointer, intent(inout) :: shared
    integer, intent(in) :: kind
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(shared_handle), pointer :: fresh
    integer :: allocation
    integer(c_int32_t) :: status

    ! A failure leaves the object held before.
    status = int(wrc_out_of_memory, c_int32_t)
    allocate (fresh, stat=allocation)
    if (allocation == 0) then
      select case (kind)
      case (scene_kind); status = wrc_scene_create_0_4(fresh%handle)
      case (solver_kind); status = wrc_solver_create(fresh%handle)
      case (profile_kind); status = wrc_profile_create(fresh%handle)
      case (normal_kind); status = wrc_normal_create(fresh%handle)
      case (rolling_kind); status = wrc_rolling_create(fresh%handle)
      case (history_kind); status = wrc_history_create(fresh%handle)
      case (table_kind); status = wrc_table_create(fresh%handle)
      end select
      if (status == wrc_ok) then
        fresh%kind = kind
        call let_go(shared)
        fresh%references = 1
        shared => fresh
      else
        deallocate (fresh)
      end if
    end if
    call report(status, 'out of memory', stat, errmsg)
  end subroutine take_new

  ! Plain assignment would copy the pointer without counting, and finalize it twice.
  subroutine take(shared, other)
    type(shared_handle), pointer, intent(inout) :: shared
    type(shared_handle), pointer, intent(in) :: other
    type(shared_handle), pointer :: taken
    taken => other
    if (associated(taken)) taken%references = taken%references + 1
    call let_go(shared)
    shared => taken
  end subroutine take

  !> Gives up one reference, and the object with the last one.
  subroutine let_go(shared)
    type(shared_handle), pointer, intent(inout) :: shared
    if (.not. associated(shared)) return
    shared%references = shared%references - 1
    if (shared%references == 0) then
      select case (shared%kind)
      case (scene_kind); call wrc_scene_destroy(shared%handle)
      case (solver_kind); call wrc_solver_destroy(shared%handle)
      case (profile_kind); call wrc_profile_destroy(shared%handle)
      case (normal_kind); call wrc_normal_destroy(shared%handle)
      case (rolling_kind); call wrc_rolling_destroy(shared%handle)
      case (history_kind); call wrc_history_destroy(shared%handle)
      case (table_kind); call wrc_table_destroy(shared%handle)
      end select
      deallocate (shared)
    end if
    shared => null()
  end subroutine let_go

  !> The handle for C; NULL, which every function refuses, if there is none yet.
  function address(shared) result(handle)
    type(shared_handle), pointer, intent(in) :: shared
    type(c_ptr) :: handle
    handle = c_null_ptr
    if (associated(shared)) handle = shared%handle
  end function address

  !> Whether an array of rank 2 has the grid's shape: the library counts values only, and a
  !> transposed one would pass. Reports if not.
  function fits(shared, what, given, stat, errmsg)
    type(shared_handle), pointer, intent(in) :: shared
    character(*), intent(in) :: what
    integer(c_int64_t), intent(in) :: given(2)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    logical :: fits
    character(120) :: failure
    fits = all(given == 0) .or. all(given == shared%grid)
    if (fits) return
    write (failure, '(a, 2(a, i0, a, i0))') what, ' shaped ', given(1), ' x ', given(2), &
      ', the grid (longitudinal, lateral) ', shared%grid(1), ' x ', shared%grid(2)
    call report(int(wrc_invalid_argument, c_int32_t), trim(failure), stat, errmsg)
  end function fits

  subroutine report_of(shared, kind, status, stat, errmsg)
    type(shared_handle), pointer, intent(in) :: shared
    integer, intent(in) :: kind
    integer(c_int32_t), intent(in) :: status
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (status == wrc_ok) then
      if (present(stat)) stat = wrc_ok
      return
    end if
    select case (kind)
    case (scene_kind)
      call report(status, fortran_text(wrc_scene_error(address(shared))), stat, errmsg)
    case (solver_kind)
      call report(status, fortran_text(wrc_solver_error(address(shared))), stat, errmsg)
    case (profile_kind)
      call report(status, fortran_text(wrc_profile_error(address(shared))), stat, errmsg)
    case (normal_kind)
      call report(status, fortran_text(wrc_normal_error(address(shared))), stat, errmsg)
    case (rolling_kind)
      call report(status, fortran_text(wrc_rolling_error(address(shared))), stat, errmsg)
    case (history_kind)
      call report(status, fortran_text(wrc_history_error(address(shared))), stat, errmsg)
    case (table_kind)
      call report(status, fortran_text(wrc_table_error(address(shared))), stat, errmsg)
    end select
  end subroutine report_of

  subroutine report(status, failure, stat, errmsg)
    integer(c_int32_t), intent(in) :: status
    character(*), intent(in) :: failure
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (present(stat)) stat = int(status)
    if (status == wrc_ok) return
    if (present(errmsg)) errmsg = failure
    if (.not. present(stat)) error stop 'wrcontact: '//failure
  end subroutine report

  !> Trailing blanks are no part of a Fortran text.
  function c_text(text) result(letters)
    character(*), intent(in) :: text
    character(:, kind=c_char), allocatable :: letters
    letters = trim(text)//c_null_char
  end function c_text

  function fortran_text(letters) result(text)
    type(c_ptr), intent(in) :: letters
    character(:), allocatable :: text
    character(kind=c_char), pointer :: letter(:)
    integer :: i
    if (.not. c_associated(letters)) then
      text = ''
      return
    end if
    call c_f_pointer(letters, letter, [strlen(letters)])
    allocate (character(size(letter)) :: text)
    do i = 1, size(letter)
      text(i:i) = letter(i)
    end do
  end function fortran_text

end module wrcontact
