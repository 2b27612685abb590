!> Wheel/rail contact from Fortran: scenes are set, solved and read through one derived type.
!>
!> Units mm, N, MPa, rad; frame, keys and names of results as in wrcontact.h. Example:
!>
!>     use wrcontact, only: contact_scene
!>     type(contact_scene) :: scene
!>     call scene%create()
!>     call scene%set('pose.lateral', 3.0_real64)
!>     call scene%set('track.rail', '54E3')
!>     call scene%set('solve.grid', [256.0_real64, 128.0_real64])
!>     call scene%solve()
!>     print *, scene%number('left.pmax'), maxval(scene%field('left.pressure'))
!>
!> Errors: every procedure takes the optional arguments `stat` (one of the wrc_* constants, 0 if all
!> went well) and `errmsg` (the text of a failure; untouched by success). Without `stat` a failure
!> ends the program by `error stop` with the text. wrc_not_converged counts as a failure; results
!> are there all the same for who asks for `stat`.
!> Assignment: after `a = b` both are the same scene; it is destroyed with the last of them.
!> Threads: one thread at a time for a scene and all that were assigned from it.
!> The module ships as source, since .mod files belong to one compiler and version.
module wrcontact
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_int32_t, &
    c_int64_t, c_loc, c_null_char, c_null_ptr, c_ptr, c_size_t
  use, intrinsic :: iso_fortran_env, only: real64
  use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
  implicit none
  private

  public :: contact_scene, library_version

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

  !> What variables that were assigned to each other have in common.
  type :: shared_handle
    type(c_ptr) :: handle = c_null_ptr
    integer :: references = 0
  end type shared_handle

  type :: contact_scene
    private
    type(shared_handle), pointer :: shared => null()
  contains
    !> A scene with the defaults of the paper's Table 1; one held before is given up.
    procedure :: create
    !> set(key, value): a real(real64), a character or a rank-1 real(real64) array.
    generic :: set => set_number, set_text, set_numbers
    procedure :: solve
    !> number(name): a scalar result; not-a-number after a failure.
    procedure :: number
    !> text(name): a text result; empty after a failure.
    procedure :: text
    !> field(name): a field of a patch ('left.patches.1.pressure'; 'left.pressure' is that of patch
    !> 0), longitudinal index fastest, or an outline ('left.rail_y'); of no length after a failure.
    procedure :: field
    generic :: assignment(=) => share
    procedure, private :: set_number, set_text, set_numbers, share
    procedure, private :: c_handle
    ! Elemental, since a scalar finalizer skips arrays.
    final :: release
  end type contact_scene

  interface
    function wrc_version() bind(C) result(text)
      import :: c_ptr
      type(c_ptr) :: text
    end function wrc_version

    function wrc_scene_create(scene) bind(C) result(status)
      import :: c_int32_t, c_ptr
      type(c_ptr), intent(out) :: scene
      integer(c_int32_t) :: status
    end function wrc_scene_create

    subroutine wrc_scene_destroy(scene) bind(C)
      import :: c_ptr
      type(c_ptr), value :: scene
    end subroutine wrc_scene_destroy

    function wrc_scene_error(scene) bind(C) result(text)
      import :: c_ptr
      type(c_ptr), value :: scene
      type(c_ptr) :: text
    end function wrc_scene_error

    function wrc_scene_set_number(scene, key, value) bind(C) result(status)
      import :: c_char, c_double, c_int32_t, c_ptr
      type(c_ptr), value :: scene
      character(kind=c_char), intent(in) :: key(*)
      real(c_double), value :: value
      integer(c_int32_t) :: status
    end function wrc_scene_set_number

    function wrc_scene_set_text(scene, key, value) bind(C) result(status)
      import :: c_char, c_int32_t, c_ptr
      type(c_ptr), value :: scene
      character(kind=c_char), intent(in) :: key(*), value(*)
      integer(c_int32_t) :: status
    end function wrc_scene_set_text

    function wrc_scene_set_numbers(scene, key, values, count) bind(C) result(status)
      import :: c_char, c_double, c_int32_t, c_int64_t, c_ptr
      type(c_ptr), value :: scene
      character(kind=c_char), intent(in) :: key(*)
      real(c_double), intent(in) :: values(*)
      integer(c_int64_t), value :: count
      integer(c_int32_t) :: status
    end function wrc_scene_set_numbers

    function wrc_scene_solve(scene) bind(C) result(status)
      import :: c_int32_t, c_ptr
      type(c_ptr), value :: scene
      integer(c_int32_t) :: status
    end function wrc_scene_solve

    function wrc_scene_number(scene, name, value) bind(C) result(status)
      import :: c_char, c_double, c_int32_t, c_ptr
      type(c_ptr), value :: scene
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), intent(inout) :: value
      integer(c_int32_t) :: status
    end function wrc_scene_number

    function wrc_scene_text(scene, name, value) bind(C) result(status)
      import :: c_char, c_int32_t, c_ptr
      type(c_ptr), value :: scene
      character(kind=c_char), intent(in) :: name(*)
      type(c_ptr), intent(inout) :: value
      integer(c_int32_t) :: status
    end function wrc_scene_text

    function wrc_scene_field(scene, name, values, capacity, count) bind(C) result(status)
      import :: c_char, c_double, c_int32_t, c_int64_t, c_ptr
      type(c_ptr), value :: scene
      character(kind=c_char), intent(in) :: name(*)
      type(c_ptr), value :: values
      integer(c_int64_t), value :: capacity
      integer(c_int64_t), intent(inout) :: count
      integer(c_int32_t) :: status
    end function wrc_scene_field

    function strlen(text) bind(C) result(length)
      import :: c_ptr, c_size_t
      type(c_ptr), value :: text
      integer(c_size_t) :: length
    end function strlen
  end interface

contains

  !> Version of the library, for example '0.1.0'.
  function library_version() result(version)
    character(:), allocatable :: version
    version = fortran_text(wrc_version())
  end function library_version

  subroutine create(self, stat, errmsg)
    class(contact_scene), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(shared_handle), pointer :: fresh
    integer :: allocation
    integer(c_int32_t) :: status

    ! A failure leaves the scene held before.
    status = int(wrc_out_of_memory, c_int32_t)
    allocate (fresh, stat=allocation)
    if (allocation == 0) then
      status = wrc_scene_create(fresh%handle)
      if (status == wrc_ok) then
        call let_go(self%shared)
        fresh%references = 1
        self%shared => fresh
      else
        deallocate (fresh)
      end if
    end if
    call report(status, 'out of memory', stat, errmsg)
  end subroutine create

  subroutine set_number(self, key, value, stat, errmsg)
    class(contact_scene), intent(in) :: self
    character(*), intent(in) :: key
    real(real64), intent(in) :: value
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call report_of(self, wrc_scene_set_number(self%c_handle(), c_text(key), value), stat, errmsg)
  end subroutine set_number

  subroutine set_text(self, key, value, stat, errmsg)
    class(contact_scene), intent(in) :: self
    character(*), intent(in) :: key, value
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call report_of(self, wrc_scene_set_text(self%c_handle(), c_text(key), c_text(value)), stat, &
      errmsg)
  end subroutine set_text

  subroutine set_numbers(self, key, values, stat, errmsg)
    class(contact_scene), intent(in) :: self
    character(*), intent(in) :: key
    real(real64), intent(in) :: values(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    ! A slice with a stride is copied for the call; the library keeps no pointer to it.
    call report_of(self, wrc_scene_set_numbers(self%c_handle(), c_text(key), values, &
      size(values, kind=c_int64_t)), stat, errmsg)
  end subroutine set_numbers

  subroutine solve(self, stat, errmsg)
    class(contact_scene), intent(in) :: self
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call report_of(self, wrc_scene_solve(self%c_handle()), stat, errmsg)
  end subroutine solve

  function number(self, name, stat, errmsg) result(value)
    class(contact_scene), intent(in) :: self
    character(*), intent(in) :: name
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(real64) :: value
    value = ieee_value(value, ieee_quiet_nan)
    call report_of(self, wrc_scene_number(self%c_handle(), c_text(name), value), stat, errmsg)
  end function number

  function text(self, name, stat, errmsg) result(value)
    class(contact_scene), intent(in) :: self
    character(*), intent(in) :: name
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(:), allocatable :: value
    type(c_ptr) :: letters
    letters = c_null_ptr
    call report_of(self, wrc_scene_text(self%c_handle(), c_text(name), letters), stat, errmsg)
    value = fortran_text(letters)
  end function text

  function field(self, name, stat, errmsg) result(values)
    class(contact_scene), intent(in) :: self
    character(*), intent(in) :: name
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(real64), allocatable, target :: values(:)
    integer(c_int64_t) :: count
    integer(c_int32_t) :: status

    count = 0
    status = wrc_scene_field(self%c_handle(), c_text(name), c_null_ptr, 0_c_int64_t, count)
    allocate (values(count))
    if (status == wrc_ok .and. count > 0) then
      status = wrc_scene_field(self%c_handle(), c_text(name), c_loc(values), count, count)
    end if
    call report_of(self, status, stat, errmsg)
  end function field

  ! Plain assignment would copy the pointer without counting, and finalize it twice.
  impure elemental subroutine share(self, other)
    class(contact_scene), intent(inout) :: self
    type(contact_scene), intent(in) :: other
    type(shared_handle), pointer :: taken
    taken => other%shared
    if (associated(taken)) taken%references = taken%references + 1
    call let_go(self%shared)
    self%shared => taken
  end subroutine share

  impure elemental subroutine release(self)
    type(contact_scene), intent(inout) :: self
    call let_go(self%shared)
  end subroutine release

  !> Gives up one reference, and the scene with the last one.
  subroutine let_go(shared)
    type(shared_handle), pointer, intent(inout) :: shared
    if (.not. associated(shared)) return
    shared%references = shared%references - 1
    if (shared%references == 0) then
      call wrc_scene_destroy(shared%handle)
      deallocate (shared)
    end if
    shared => null()
  end subroutine let_go

  !> The handle for C; NULL, which every function refuses, if there is none yet.
  function c_handle(self) result(handle)
    class(contact_scene), intent(in) :: self
    type(c_ptr) :: handle
    handle = c_null_ptr
    if (associated(self%shared)) handle = self%shared%handle
  end function c_handle

  subroutine report_of(self, status, stat, errmsg)
    class(contact_scene), intent(in) :: self
    integer(c_int32_t), intent(in) :: status
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call report(status, fortran_text(wrc_scene_error(self%c_handle())), stat, errmsg)
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
