! Wheel/rail contact for programs in FORTRAN 77: external subroutines,
! no module, nothing to include for the caller. Compile this file, which
! includes wrcontact_c.inc and wrcontact_f77_*.inc, with the program,
! link with -lwrcontact; docs/fortran.md shows a complete program.
!
!   INTEGER*8 HANDLE         scene, solver, profile, normal or rolling
!                            contact, table or history
!   REAL*8                   all numbers; mm, N, MPa, rad, y left, z up,
!                            unless the scene's convention differs
!   CHARACTER*(*)            keys and texts; trailing blanks do not
!                            count
!   INTEGER                  counts, and IERR, always last, always set:
!                            0, or a status of wrcontact.h (1 invalid
!                            argument, 2 unknown name, 3 file
!                            unreadable, 4 file malformed, 5 no contact,
!                            6 out of memory, 7 internal, 8 not
!                            converged, with results, 9 too small,
!                            10 no result, 11 busy)
!
! Keys, names of results and ranges: wrcontact.h, docs/results.md.
!
! Integers of the program may have 4 or 8 bytes (-fdefault-integer-8),
! whatever this file is compiled with: WRCOPN takes KIND(0), written
! exactly so, and marks the handle with it. A handle may be used only
! by program parts compiled with the same option. Reals must have 8
! bytes: WRCOPN takes 1.0D0, written exactly so, and refuses a program
! in which it has 16 (-fdefault-real-8 without -fdefault-double-8).
!
!   WRCOPN(HANDLE, WHAT, KIND(0), 1.0D0, IERR)   makes a 'scene',
!                                          'solver', 'profile',
!                                          'normal', 'rolling', 'table'
!                                          or 'history'
!   WRCNEW(HANDLE, WHAT, KIND(0), IERR)    the same without looking at
!                                          reals
!   WRCDEL(HANDLE, IERR)                   destroys it, sets it to 0
!   WRCERR(HANDLE, TEXT, IERR)             text of its last failure
!   WRCVER(TEXT)                           version of the library
!
!   WRCSET(HANDLE, KEY, VALUE, IERR)       number of a scene or contact
!   WRCSTX(HANDLE, KEY, TEXT, IERR)        text of a scene, contact or
!                                          solver (its options)
!   WRCSTN(SCENE, KEY, VALUES, N, IERR)    numbers
!   WRCGET(SCENE, KEY, VALUE, IERR)        the number of a key
!   WRCGTX(SCENE, KEY, TEXT, IERR)         the text of a key
!   WRCPUT(SCENE, KEY, PROFIL, IERR)       lets the scene use a profile
!   WRCWRT(SCENE, PATH, IERR)              a file that wrc_case replays
!
!   WRCSOL(HANDLE, IERR)                   solves a scene or contact
!   WRCSTP(SOLVER, SCENE, IERR)            a vehicle step: solves the
!                                          scene with kept data
!   WRCCLR(SOLVER, IERR)                   drops the kept data
!
!   Vehicle simulations (wrc_solver_step and the calls below it in
!   wrcontact.h):
!   WRCVEH(SOLVER, SCENE, Q, V, IRAILS, RAILS, F, IDERIV, DFDQ, DFDV,
!          ISTATE, IERR)
!        one evaluation of a wheelset. Q(6): x, y, z, roll, pitch angle,
!        yaw; V(6): their rates; IRAILS 1: RAILS(3,2), displacements of
!        the left and the right rail, 0: as in the scene; F(6,2): force
!        and moment on the left and the right wheel about the
!        wheelset's centre; IDERIV 1: DFDQ(6,6,2), DFDV(6,6,2), of F(I,K)
!        by Q(J), V(J), 0: neither; ISTATE(2): 1 lifted + 2 flange tip
!        + 4 chamfer + 8 beyond yield + 32 end of a rail's part
!   WRCVEX(SOLVER, SCENE, Q, V, IOPT, OPT, F, DFDQ, DFDV, DFDR, DFDW,
!          ISTATE, IERR)
!        WRCVEH with more arguments: OPT(15): rails(3,2), their rates
!        (3,2), curvature of the track, friction of the left and the
!        right wheel; IOPT(1) to IOPT(4) 1: uses them, 0: as in the
!        scene; IOPT(5) 1: DFDQ, DFDV, and DFDR(6,3,2), DFDW(6,3,2), of
!        F(I,K) by displacement J of rail K and by its rate
!   WRCVHX(SOLVER, SCENE, HIST, DT, Q, V, IOPT, OPT, F, DFDQ, DFDV,
!          DFDR, DFDW, ISTATE, IERR)
!        WRCVEX over a time step of DT seconds from what the wheelset's
!        history HIST accepted last, instead of steady rolling: for runs
!        that stop, park or start
!   WRCHAC(HIST, IERR)                     accepts what the last step
!                                          found: once for each step that
!                                          the program keeps
!   WRCHCL(HIST, IERR)                     forgets everything
!   WRCHCP(HIST, FROM, IERR)               makes it a copy of FROM
!   WRCEQL(SOLVER, SCENE, IKIND, LOADS, IVEL, V, IOPT, OPT, Q, F, DFDQ,
!          DFDV, DFDR, DFDW, ISTATE, IERR)
!        static equilibrium: Q(3) and Q(4) at which the wheels carry
!        LOADS(2): IKIND 0: of the left and the right wheel; 1: of the
!        axle, and moment about x. IVEL 1: V(6), 0: as in the scene
!   WRCPAT(SCENE, PATCH, LENP, N, IERR)
!        patches: N of them, PATCH(22,LENP) if LENP is at least N;
!        otherwise N only. The first 22 members of wrc_patch in
!        wrcontact.h; others as results by name
!   WRCCRP(SOLVER, SCENE, IPATCH, CREEP, FORCE, IDERIV, DERIV, IERR)
!        FORCE(3) of patch IPATCH, from 1, at CREEP(3) of the program's
!        own; IDERIV 1: DERIV(3,3), of FORCE(J) by CREEP(I)
!   WRCTAB(SCENE, KEYS, VALUES, COUNTS, N, NAMES, NTHR, PATH, TABLE,
!          IERR)
!        a table over values of N keys, COUNTS(N) of each; KEYS and
!        NAMES (of results) separated by blanks; NTHR threads; PATH: a
!        file, or blank
!
!   Contact forces from a table that states its error (wrc_table_build
!   and the calls below it in wrcontact.h, docs/table.md):
!   WRCTMK(CTABLE, SCENE, RANGES, NTHR, IERR)
!        makes one for a scene, in minutes; RANGES(6): lateral position,
!        roll, yaw, largest load, tolerance, fineness; 0: the default
!   WRCTLD(CTABLE, PATH, IERR)             reads one from a file
!   WRCTSV(CTABLE, PATH, IERR)             writes it
!   WRCTSH(CTABLE, OTHER, IERR)            lets handle OTHER use it too
!   WRCTFA(CTABLE, FACTS, IERR)            FACTS(13): the members of
!                                          wrc_table_facts after the first
!   WRCTVX(CTABLE, SOLVER, SCENE, Q, V, IOPT, OPT, F, DFDQ, DFDV, DFDR,
!          DFDW, ERRORS, ISTATE, IERR)
!        WRCVEX from the table; what IOPT leaves out is 0, friction that
!        of the table. SOLVER and SCENE for the exact solution, or both
!        0; ERRORS(2): how far the force of each wheel may be off, over
!        its vertical force; ISTATE(2): 16 solved exactly
!   WRCTVO(CTABLE, SOLVER, SCENE, Q, V, IOPT, OPT, F, DFDQ, DFDV, DFDR,
!          DFDW, ERRORS, XLIKEL, OUT, OUTERR, ISTATE, IERR)
!        WRCTVX with likely errors and outputs: XLIKEL(2,2), the errors
!        of force and derivatives that 99 of 100 keep; OUT(8,2), wear
!        number, t and s, angle and radius at the centre of pressure,
!        normal forces of tread and flange, 1 on the flange tip; and
!        OUTERR(8,2), their likely errors
!
!   WRCNUM(HANDLE, NAME, VALUE, IERR)      result of a scene or contact
!   WRCTXT(HANDLE, NAME, TEXT, IERR)       a text of a scene, profile or
!                                          normal contact
!   WRCWRN(HANDLE, I, TEXT, IERR)          warning I, from 1, of a solved
!                                          scene or a profile; blank past
!                                          the end. WRCNUM of
!                                          'warning_count' counts those of
!                                          a scene
!   WRCFLD(HANDLE, NAME, VALUES, LENV, N, IERR)
!        a field: N values, longitudinal index fastest, if LENV is at
!        least N; otherwise N only. LENV = 0 returns N, without error
!
!   Ids of keys and of names of results, for many steps; the same for
!   all scenes of one version of the library:
!   WRCKID(SCENE, KEY, ID, IERR)           id of a key
!   WRCNID(SCENE, NAME, ID, IERR)          id of the name of a result
!   WRCSTB(SCENE, IDS, VALUES, N, IERR)    sets N keys to numbers: all
!                                          or, if one is refused, none
!   WRCRDB(SCENE, IDS, VALUES, N, IERR)    reads N results; those that
!                                          are not there: not-a-number
!
!   WRCSTD(PROFIL, NAME, IERR)             a built-in profile
!   WRCFIL(PROFIL, PATH, IERR)             a profile's file
!   WRCPTS(PROFIL, NAME, IKIND, Y, Z, N, IERR)
!        a profile through points; IKIND 0: wheel, 1: rail
!   WRCFLX(PROFIL, PATH, IKIND, MIRY, MIRZ, ISTRCT, SCALE, SMOOTH,
!          IERR)
!   WRCPTX(PROFIL, NAME, IKIND, Y, Z, N, MIRY, MIRZ, ISTRCT, SCALE,
!          SMOOTH, IERR)
!        the same, and how they are read: IKIND -1 as the file says;
!        MIRY, MIRZ 0 mirrored if needed, 1 mirrored, -1 not; ISTRCT 1
!        refuses instead of guessing; SCALE mm per unit, 0 guessed;
!        SMOOTH wavelength in mm that is halved, 0 no smoothing,
!        negative: as the noise of the points needs
!
!   WRCGRD(HANDLE, NLAT, NLON, DLAT, DLON, IERR)   grid of a contact
!   WRCGAP(NORMAL, DIST, N, IERR)          undeformed distance at the
!                                          element centres, as a field
!   WRCPRS(ROLLNG, PRESS, N, IERR)         pressures, as a field
!   WRCPRV(ROLLNG, QX, QY, N, IERR)        tractions before a step or a
!                                          shift; N = 0: none
!   WRCADV(ROLLNG, IERR)                   those found become them
!
! If a call fails, numbers keep their values and texts become blank.

! The C interface, and code common to the subroutines.
module wrcontact_f77_c
  use, intrinsic :: iso_c_binding
  implicit none
  public

  integer, parameter :: scene_mark = 1, solver_mark = 2
  integer, parameter :: profile_mark = 4, normal_mark = 8
  integer, parameter :: rolling_mark = 16, table_mark = 32
  integer, parameter :: history_mark = 64, any_mark = 127
  integer, parameter :: contact_mark = normal_mark + rolling_mark
  ! Not a handle, nor a number that a program holds by chance: marks a program whose reals WRCOPN
  ! has refused.
  integer(c_int64_t), parameter :: refused_reals = 7311906854028371424_c_int64_t
  ! Where the checksum of a handle begins.
  integer(c_int64_t), parameter :: first_check = 2_c_int64_t**43
  ! The handle last refused since it is of another kind; 0: it has been used as it should since.
  integer(c_int64_t), save, volatile :: misused = 0
  ! WRC_SMOOTHING_NONE and WRC_SMOOTHING_AUTO of wrcontact.h.
  real(c_double), parameter :: smoothing_none = -1, smoothing_auto = -2

  include 'wrcontact_c.inc'

contains

  ! The library's handles are multiples of 32. The low two bits say how
  ! many bytes the caller's integers have (1: 4, 2: 8), the next three
  ! what it is. A checksum lies above, so that a handle that was never
  ! made is not believed: IERR of 4 bytes must not be written as 8.
  integer(c_int64_t) function sealed(marked)
    integer(c_int64_t), intent(in) :: marked
    !     A prime below 2**20; the sum is not 0, as above small numbers.
    integer(c_int64_t), parameter :: prime = 1048573
    sealed = marked + first_check*(mod(marked, prime) + 1)
  end function sealed

  logical function is_sealed(handle)
    integer(c_int64_t), intent(in) :: handle
    is_sealed = handle .eq. sealed(iand(handle, first_check - 1))
  end function is_sealed

  ! Address and width of a handle that is of one of the kinds; status 1
  ! without. The width is that of IERR in any case.
  subroutine look(handle, kinds, address, kind, width, status)
    integer(c_int64_t), intent(in) :: handle
    integer, intent(in) :: kinds
    type(c_ptr), intent(out) :: address
    integer, intent(out) :: kind, width
    integer(c_int32_t), intent(out) :: status
    integer(c_int64_t) :: number
    !     Four bytes that are not zero make eight that are not zero.
    width = 4
    kind = 0
    address = c_null_ptr
    status = 1
    if (handle .eq. refused_reals + 2) width = 8
    if (.not. is_sealed(handle)) return
    width = 4*int(iand(handle, 3_c_int64_t))
    kind = int(ishft(1_c_int64_t, int(iand(ishft(handle, -2), 7_c_int64_t))))
    if (iand(kind, kinds) .eq. 0) then
      misused = handle
      return
    end if
    if (handle .eq. misused) misused = 0
    number = iand(handle, first_check - 32)
    address = transfer(number, c_null_ptr)
    status = 0
  end subroutine look

  ! What a handle of a kind is called.
  character(16) function name_of(kind)
    integer, intent(in) :: kind
    select case (kind)
    case (scene_mark)
      name_of = 'scene'
    case (solver_mark)
      name_of = 'solver'
    case (profile_mark)
      name_of = 'profile'
    case (normal_mark)
      name_of = 'normal contact'
    case (rolling_mark)
      name_of = 'rolling contact'
    case (table_mark)
      name_of = 'table'
    case default
      name_of = 'history'
    end select
  end function name_of

  ! Address of another handle of a call; status 1 if its integers are of another width. One of
  ! another kind is passed on: the library refuses it, with a text for the first handle.
  subroutine look_also(handle, width, address, status)
    integer(c_int64_t), intent(in) :: handle
    integer, intent(in) :: width
    type(c_ptr), intent(out) :: address
    integer(c_int32_t), intent(inout) :: status
    integer :: kind, other
    address = c_null_ptr
    if (status .ne. 0) return
    call look(handle, any_mark, address, kind, other, status)
    if (other .ne. width) status = 1
  end subroutine look_also

  ! Those of a solver and a scene.
  subroutine look_both(solver, scene, address, other, width, status)
    integer(c_int64_t), intent(in) :: solver, scene
    type(c_ptr), intent(out) :: address, other
    integer, intent(out) :: width
    integer(c_int32_t), intent(out) :: status
    integer :: kind
    call look(solver, solver_mark, address, kind, width, status)
    call look_also(scene, width, other, status)
  end subroutine look_both

  ! Further arguments of a step: see WRCVEX.
  function more_arguments(iopt, opt, dfdq, dfdv, dfdr, dfdw, states, width) result(arguments)
    integer(c_int32_t), intent(in) :: iopt(*)
    real(c_double), intent(in), target :: opt(15)
    real(c_double), intent(in), target :: dfdq(*), dfdv(*), dfdr(*), dfdw(*)
    integer(c_int32_t), intent(in), target :: states(2)
    integer, intent(in) :: width
    type(wrc_step_arguments) :: arguments
    arguments = wrc_step_arguments(0, c_null_ptr, c_null_ptr, c_null_ptr, c_null_ptr, c_null_ptr, &
      c_null_ptr, c_null_ptr, c_null_ptr, c_null_ptr)
    arguments%struct_size = c_sizeof(arguments)
    if (wanted(1)) arguments%rails = c_loc(opt(1))
    if (wanted(2)) arguments%rail_velocities = c_loc(opt(7))
    if (wanted(3)) arguments%curvature = c_loc(opt(13))
    if (wanted(4)) arguments%friction = c_loc(opt(14))
    if (wanted(5)) then
      arguments%by_position = c_loc(dfdq)
      arguments%by_velocity = c_loc(dfdv)
      arguments%by_rail = c_loc(dfdr)
      arguments%by_rail_velocity = c_loc(dfdw)
    end if
    arguments%states = c_loc(states)
  contains
    logical function wanted(i)
      integer, intent(in) :: i
      wanted = taken(iopt(1 + (i - 1)*width/4), width) .eq. 1
    end function wanted
  end function more_arguments

  ! WRCTVX, and with the last three WRCTVO.
  subroutine step_by_table(ctable, solver, scene, q, v, iopt, opt, f, dfdq, dfdv, dfdr, dfdw, errors, istate, ierr, &
    likely, outputs, output_errors)
    integer(c_int64_t), intent(in) :: ctable, solver, scene
    real(c_double), intent(in) :: q(6), v(6)
    integer(c_int32_t), intent(in) :: iopt(*)
    real(c_double), intent(in), target :: opt(15)
    real(c_double), intent(inout) :: f(6,2), errors(2)
    real(c_double), intent(inout), target :: dfdq(*), dfdv(*), dfdr(*), dfdw(*)
    integer(c_int32_t), intent(inout) :: istate(*), ierr(*)
    real(c_double), intent(inout), target, optional :: likely(2,2), outputs(8,2), output_errors(8,2)
    integer(c_int32_t), target :: states(2)
    type(wrc_step_arguments) :: arguments
    type(c_ptr) :: address, with, posed
    integer(c_int32_t) :: status
    integer :: kind, width
    call look(ctable, table_mark, address, kind, width, status)
    with = c_null_ptr
    posed = c_null_ptr
    if (solver .ne. 0) call look_also(solver, width, with, status)
    if (scene .ne. 0) call look_also(scene, width, posed, status)
    if (status .eq. 0) then
      states = 0
      arguments = more_arguments(iopt, opt, dfdq, dfdv, dfdr, dfdw, states, width)
      if (present(likely)) arguments%likely_errors = c_loc(likely)
      if (present(outputs)) arguments%outputs = c_loc(outputs)
      if (present(output_errors)) arguments%output_errors = c_loc(output_errors)
      status = wrc_table_step(address, with, posed, q, v, arguments, f, errors)
      if (status .eq. 0 .or. status .eq. 8) call give_two(states, istate, width)
    end if
    call finish(status, ierr, width)
  end subroutine step_by_table

  ! The caller's integer of 4 or 8 bytes.
  integer(c_int64_t) function taken(number, width)
    integer(c_int32_t), intent(in), target :: number(*)
    integer, intent(in) :: width
    integer(c_int64_t), pointer :: wide
    if (width .eq. 8) then
      call c_f_pointer(c_loc(number), wide)
      taken = wide
    else
      taken = number(1)
    end if
  end function taken

  subroutine give(value, number, width)
    integer(c_int64_t), intent(in) :: value
    integer(c_int32_t), intent(inout), target :: number(*)
    integer, intent(in) :: width
    integer(c_int64_t), pointer :: wide
    if (width .eq. 8) then
      call c_f_pointer(c_loc(number), wide)
      wide = value
    else
      number(1) = int(value, c_int32_t)
    end if
  end subroutine give

  ! Both integers of a pair.
  subroutine give_two(values, numbers, width)
    integer(c_int32_t), intent(in) :: values(2)
    integer(c_int32_t), intent(inout) :: numbers(*)
    integer, intent(in) :: width
    call give(int(values(1), c_int64_t), numbers, width)
    call give(int(values(2), c_int64_t), numbers(1 + width/4), width)
  end subroutine give_two

  ! Ids of 8 bytes as C takes them; what has no room is none.
  function narrowed(ids, n)
    integer(c_int32_t), intent(in), target :: ids(*)
    integer(c_int64_t), intent(in) :: n
    integer(c_int32_t), allocatable :: narrowed(:)
    integer(c_int64_t), pointer :: wide(:)
    !     C takes up to 2**20 of them.
    call c_f_pointer(c_loc(ids), wide, [max(0_c_int64_t, min(n, 2_c_int64_t**20))])
    narrowed = int(max(-1_c_int64_t, min(wide, int(huge(0_c_int32_t), c_int64_t))), c_int32_t)
  end function narrowed

  ! As C takes the lengths of lists.
  function widened(counts, n, width)
    integer(c_int32_t), intent(in), target :: counts(*)
    integer(c_int64_t), intent(in) :: n
    integer, intent(in) :: width
    integer(c_int64_t), allocatable :: widened(:)
    integer(c_int64_t), pointer :: wide(:)
    integer(c_int64_t) :: most
    most = max(0_c_int64_t, min(n, 2_c_int64_t**10))
    if (width .eq. 8) then
      call c_f_pointer(c_loc(counts), wide, [most])
      widened = wide
    else
      widened = int(counts(:most), c_int64_t)
    end if
  end function widened

  ! How a file or points are read. IKIND -1: the kind is not given.
  function reading(ikind, miry, mirz, istrct, scale, smooth, width)
    integer(c_int32_t), intent(in) :: ikind(*), miry(*), mirz(*)
    integer(c_int32_t), intent(in) :: istrct(*)
    real(c_double), intent(in) :: scale, smooth
    integer, intent(in) :: width
    type(wrc_read_options) :: reading
    reading = wrc_read_options(0, 0, 0, 0, 0, 0, 0, scale, smooth, 0, 0, 0, 0, 0, 0, 0, c_null_ptr)
    if (abs(smooth) .le. 0) reading%smoothing_wavelength = smoothing_none
    if (smooth .lt. 0) reading%smoothing_wavelength = smoothing_auto
    reading%struct_size = c_sizeof(reading)
    reading%kind = int(taken(ikind, width), c_int32_t)
    if (reading%kind .ne. -1) reading%kind_given = 1
    reading%mirror_lateral = int(taken(miry, width), c_int32_t)
    reading%mirror_height = int(taken(mirz, width), c_int32_t)
    reading%strict = int(taken(istrct, width), c_int32_t)
  end function reading

  subroutine finish(status, ierr, width)
    integer(c_int32_t), intent(in) :: status
    integer(c_int32_t), intent(inout) :: ierr(*)
    integer, intent(in) :: width
    call give(int(status, c_int64_t), ierr, width)
  end subroutine finish

  function letters(text)
    character*(*), intent(in) :: text
    character(len_trim(text) + 1, c_char) :: letters
    letters = trim(text)//c_null_char
  end function letters

  ! Blank if there is none; status 9 if it was cut.
  subroutine copy(address, text, status)
    type(c_ptr), intent(in) :: address
    character*(*), intent(inout) :: text
    integer(c_int32_t), intent(inout) :: status
    character(kind=c_char), pointer :: letter(:)
    integer :: i, length
    text = ' '
    if (.not. c_associated(address)) return
    length = int(strlen(address))
    call c_f_pointer(address, letter, [length])
    do i = 1, min(length, len(text))
      text(i:i) = letter(i)
    end do
    if (length .gt. len(text) .and. status .eq. 0) status = 9
  end subroutine copy
end module wrcontact_f77_c

include 'wrcontact_f77_handle.inc'
include 'wrcontact_f77_scene.inc'
include 'wrcontact_f77_table.inc'
include 'wrcontact_f77_profile.inc'
include 'wrcontact_f77_contact.inc'
