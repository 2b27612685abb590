!> Time integration and stability of a coach.
!>
!> Implicit: the generalized-alpha method (Chung & Hulbert 1993) in the form of Arnold & Bruels (2007), of second order,
!> with one unknown, the accelerations f at the end of a step:
!>
!>   (1 - am) a' + am a = (1 - af) f' + af f
!>   p' = p + h v + h^2 ((1/2 - beta) a + beta a'),   v' = v + h ((1 - gamma) a + gamma a'),   f' = f(t + h, p', v')
!>
!> Newton's iteration with the matrix 1 - (1 - af)/(1 - am) (h gamma df/dv + h^2 beta df/dp), LU factors by LAPACK. They
!> are kept for some steps, with the rate at which the iteration has converged with them; it stops when this rate
!> promises an error below the tolerance (Hairer & Wanner 1996, IV.8), mostly after the first iteration.
!>
!> Explicit: the classical Runge-Kutta method of order 4, four evaluations a step. Steps are limited by the contact's
!> frequency (1000/s) and by the damping of creep forces, which grows as the speed falls.
!>
!> All that a run goes on from is in its history, so that a run that is saved and restarted gives the same bits.
module coach_runs
  use, intrinsic :: iso_fortran_env, only: real64
  use coach_model, only: accelerations, centred_state, coach, position_count
  implicit none
  private
  public :: history, begin, advance, critical_speed, growth_in_time

  integer, parameter :: n = position_count, max_iterations = 20, max_halvings = 6
  real(real64), parameter :: shortest = 1.0_real64/64 !< part of a correction
  !> Spectral radius at infinite frequency, and the method's parameters.
  real(real64), parameter :: rho = 0.6_real64
  real(real64), parameter :: am = (2*rho - 1)/(rho + 1), af = rho/(rho + 1), gamma = 0.5_real64 - am + af
  real(real64), parameter :: beta = (gamma + 0.5_real64)**2/4
  real(real64), parameter :: share = (1 - af)/(1 - am)
  !> Error of positions, in m and rad, over the accuracy of contact forces: these then follow from the state to some
  !> hundredths of their uncertainty, 10 N of 110 kN at 1e-2. The forces that a step reports are those before its last
  !> correction, which is therefore at most 1e-7 m (100 N) if it is the first.
  real(real64), parameter :: tolerance = 1.0e-6_real64, largest_first = 1.0e-7_real64
  !> Velocities change creep forces less than positions normal ones: by 6e5 N s/m at 40 m/s, instead of 1e9 N/m.
  real(real64), parameter :: velocity_weight = 1.0e-3_real64
  !> The rate of convergence that a new matrix is trusted with, and the least that any is.
  real(real64), parameter :: expected_rate = 0.1_real64, least_rate = 0.1_real64
  !> Hunting, in rad/s: faster than the car body on its springs, slower than wheelsets on the contacts.
  real(real64), parameter :: slowest = 12, fastest = 300

  !> What a run goes on from besides positions and velocities, and what it has taken.
  type history
    logical :: explicit = .false.
    integer :: keep = 20 !< steps that a matrix serves
    real(real64) :: tighter = 1 !< factor of the tolerance
    real(real64) :: a(n) = 0, f(n) = 0 !< of the method, by the forces
    real(real64) :: matrix(n, n) = 0, step = 0, rate = expected_rate !< LU factors, for this step
    integer :: pivots(n) = 0, age = 0
    integer :: steps = 0, halved = 0, jacobians = 0, iterations = 0
  end type history

  interface
    subroutine dgetrf(m, n, a, lda, ipiv, info)
      import real64
      integer, intent(in) :: m, n, lda
      real(real64), intent(inout) :: a(lda, *)
      integer, intent(out) :: ipiv(*), info
    end subroutine dgetrf
    subroutine dgetrs(trans, n, nrhs, a, lda, ipiv, b, ldb, info)
      import real64
      character, intent(in) :: trans
      integer, intent(in) :: n, nrhs, lda, ipiv(*), ldb
      real(real64), intent(in) :: a(lda, *)
      real(real64), intent(inout) :: b(ldb, *)
      integer, intent(out) :: info
    end subroutine dgetrs
    subroutine dgeev(jobvl, jobvr, n, a, lda, wr, wi, vl, ldvl, vr, ldvr, work, lwork, info)
      import real64
      character, intent(in) :: jobvl, jobvr
      integer, intent(in) :: n, lda, ldvl, ldvr, lwork
      real(real64), intent(inout) :: a(lda, *), work(*)
      real(real64), intent(out) :: wr(*), wi(*), vl(ldvl, *), vr(ldvr, *)
      integer, intent(out) :: info
    end subroutine dgeev
  end interface

contains

  !> A run begins, at the accelerations that the state has.
  subroutine begin(vehicle, t, p, v, past, failed)
    type(coach), intent(inout) :: vehicle
    real(real64), intent(in) :: t, p(n), v(n)
    type(history), intent(inout) :: past
    logical, intent(out) :: failed
    call accelerations(vehicle, t, p, v, past%f, failed)
    past%a = past%f
    past%step = 0
  end subroutine begin

  !> Over a step h from the time t; one in which the iteration fails is taken in two halves.
  recursive subroutine advance(vehicle, t, h, p, v, past, failed, halvings)
    type(coach), intent(inout) :: vehicle
    real(real64), intent(in) :: t, h
    real(real64), intent(inout) :: p(n), v(n)
    type(history), intent(inout) :: past
    logical, intent(out) :: failed
    integer, intent(in), optional :: halvings
    integer :: depth, half
    depth = 0
    if (present(halvings)) depth = halvings
    if (past%explicit) then
      call take_explicit_step(vehicle, t, h, p, v, past, failed)
    else
      call take_implicit_step(vehicle, t, h, p, v, past, failed)
    end if
    if (.not. failed) past%steps = past%steps + 1
    if (.not. failed .or. depth >= max_halvings) return
    past%halved = past%halved + 1
    do half = 0, 1
      call advance(vehicle, t + half*h/2, h/2, p, v, past, failed, depth + 1)
      if (failed) return
    end do
  end subroutine advance

  !> On failure the state stays.
  subroutine take_explicit_step(vehicle, t, h, p, v, past, failed)
    type(coach), intent(inout) :: vehicle
    real(real64), intent(in) :: t, h
    real(real64), intent(inout) :: p(n), v(n)
    type(history), intent(inout) :: past
    logical, intent(out) :: failed
    real(real64) :: v2(n), v3(n), v4(n), f2(n), f3(n), f4(n), after(n), p_after(n), v_after(n)
    v2 = v + h/2*past%f
    call accelerations(vehicle, t + h/2, p + h/2*v, v2, f2, failed)
    if (failed) return
    v3 = v + h/2*f2
    call accelerations(vehicle, t + h/2, p + h/2*v2, v3, f3, failed)
    if (failed) return
    v4 = v + h*f3
    call accelerations(vehicle, t + h, p + h*v3, v4, f4, failed)
    if (failed) return
    p_after = p + h/6*(v + 2*v2 + 2*v3 + v4)
    v_after = v + h/6*(past%f + 2*f2 + 2*f3 + f4)
    call accelerations(vehicle, t + h, p_after, v_after, after, failed)
    if (failed) return
    p = p_after
    v = v_after
    past%f = after
    past%a = after
  end subroutine take_explicit_step

  !> On failure the state stays.
  subroutine take_implicit_step(vehicle, t, h, p, v, past, failed)
    type(coach), intent(inout) :: vehicle
    real(real64), intent(in) :: t, h
    real(real64), intent(inout) :: p(n), v(n)
    type(history), intent(inout) :: past
    logical, intent(out) :: failed
    real(real64) :: f(n), a(n), known(n), known_p(n), known_v(n), size, previous, part
    integer :: iteration
    logical :: new
    f = past%f
    known = (af*past%f - am*past%a)/(1 - am)
    known_p = p + h*v + h**2*(0.5_real64 - beta)*past%a
    known_v = v + h*(1 - gamma)*past%a
    new = abs(past%step - h) > 0 .or. past%age >= past%keep
    previous = huge(previous)
    part = 1
    do iteration = 1, max_iterations
      a = share*f + known
      call correct(vehicle, t + h, h, known_p + h**2*beta*a, known_v + h*gamma*a, new, part, &
        f, size, past, failed)
      if (failed) exit
      if (iteration > 1 .and. .not. new) past%rate = max(least_rate, size/previous)
      if (size*past%rate <= past%tighter*tolerance*vehicle%accuracy .and. &
        (iteration > 1 .or. size <= largest_first) .and. .not. part < 1) exit
      ! A matrix with which the iteration hardly converges is replaced. Corrections that go back and forth, as between
      ! sticking and sliding, are shortened.
      if (new .and. size > 0.7_real64*previous) then
        part = max(shortest, part/2)
      else
        part = min(1.0_real64, 2*part)
      end if
      new = iteration > 1 .and. size > 0.3_real64*previous .or. part < 1
      previous = size
    end do
    if (.not. failed) failed = iteration > max_iterations
    if (failed) then
      past%step = 0
      if (iteration > max_iterations) vehicle%message = 'Newton''s iteration does not converge'
      return
    end if
    a = share*f + known
    p = known_p + h**2*beta*a
    v = known_v + h*gamma*a
    past%a = a
    past%f = f
    past%age = past%age + 1
  end subroutine take_implicit_step

  !> One iteration for the accelerations, with a new matrix or the one that is there, by a part of the correction.
  subroutine correct(vehicle, t, h, p, v, new, part, f, size, past, failed)
    type(coach), intent(inout) :: vehicle
    real(real64), intent(in) :: t, h, p(n), v(n), part
    logical, intent(in) :: new
    real(real64), intent(inout) :: f(n)
    real(real64), intent(out) :: size
    type(history), intent(inout) :: past
    logical, intent(out) :: failed
    real(real64) :: found(n), correction(n, 1), by_p(n, n), by_v(n, n)
    integer :: i, info
    size = 0
    past%iterations = past%iterations + 1
    if (new) then
      call accelerations(vehicle, t, p, v, found, failed, by_p, by_v)
      if (failed) return
      past%jacobians = past%jacobians + 1
      past%matrix = -share*(h*gamma*by_v + h**2*beta*by_p)
      do i = 1, n
        past%matrix(i, i) = past%matrix(i, i) + 1
      end do
      call dgetrf(n, n, past%matrix, n, past%pivots, info)
      past%step = h
      past%age = 0
      past%rate = expected_rate
    else
      call accelerations(vehicle, t, p, v, found, failed)
      if (failed) return
    end if
    correction(:, 1) = found - f
    call dgetrs('N', n, 1, past%matrix, n, past%pivots, correction, n, info)
    f = f + part*correction(:, 1)
    size = share*max(h**2*beta, velocity_weight*h*gamma)*maxval(abs(correction(:, 1)))
  end subroutine correct

  !> The oscillation of the wheelsets about the centred state, linearised with the Jacobian, that decays least:
  !> eigenvalue in 1/s, motion, and the left eigenvector that gives its amplitude in any motion.
  subroutine least_stable_mode(vehicle, p, v, eigenvalue, mode, share_of, failed)
    type(coach), intent(inout) :: vehicle
    real(real64), intent(out) :: p(n), v(n) !< the centred state
    complex(real64), intent(out) :: eigenvalue, mode(2*n), share_of(2*n)
    logical, intent(out) :: failed
    real(real64) :: jacobian(2*n, 2*n), rate(n), re(2*n), im(2*n), left(2*n, 2*n), right(2*n, 2*n), work(40*n)
    integer :: i, info
    eigenvalue = 0
    mode = 0
    share_of = 0
    call centred_state(vehicle, p, v, failed)
    if (failed) return
    jacobian = 0
    call accelerations(vehicle, 0.0_real64, p, v, rate, failed, jacobian(n + 1:, :n), jacobian(n + 1:, n + 1:))
    if (failed) return
    do i = 1, n
      jacobian(i, n + i) = 1
    end do
    call dgeev('V', 'V', 2*n, jacobian, 2*n, re, im, left, 2*n, right, 2*n, work, size(work), info)
    i = maxloc(re, 1, im > slowest .and. im < fastest)
    eigenvalue = cmplx(re(i), im(i), real64)
    mode = cmplx(right(:, i), right(:, i + 1), real64)
    share_of = cmplx(left(:, i), left(:, i + 1), real64)
  end subroutine least_stable_mode

  !> Speed at which the least stable oscillation neither grows nor decays, by bisection between two.
  subroutine critical_speed(vehicle, slow, fast, failed)
    type(coach), intent(inout) :: vehicle
    real(real64), intent(in) :: slow, fast
    logical, intent(out) :: failed
    real(real64) :: bounds(2), p(n), v(n)
    complex(real64) :: eigenvalue, mode(2*n), share_of(2*n)
    bounds = [slow, fast]
    failed = .false.
    do while (bounds(2) - bounds(1) > 1.0e-3_real64*bounds(1) .and. .not. failed)
      vehicle%speed = sum(bounds)/2
      call least_stable_mode(vehicle, p, v, eigenvalue, mode, share_of, failed)
      bounds(merge(2, 1, real(eigenvalue) > 0)) = vehicle%speed
    end do
  end subroutine critical_speed

  !> Rate at which the least stable oscillation grows in time, 1/s, over some seconds, and what its eigenvalue says.
  subroutine growth_in_time(vehicle, amplitude, seconds, h, past, growth, eigenvalue, failed)
    type(coach), intent(inout) :: vehicle
    real(real64), intent(in) :: amplitude !< m, of the largest lateral motion of a wheelset
    real(real64), intent(in) :: seconds, h
    type(history), intent(inout) :: past
    real(real64), intent(out) :: growth
    complex(real64), intent(out) :: eigenvalue
    logical, intent(out) :: failed
    real(real64) :: p(n), v(n), p0(n), v0(n)
    complex(real64) :: mode(2*n), share_of(2*n)
    integer :: i, steps, largest
    growth = 0
    call least_stable_mode(vehicle, p0, v0, eigenvalue, mode, share_of, failed)
    if (failed) return
    largest = 14 + 6*maxloc(abs(mode(20:n:6)), 1)
    mode = mode*amplitude/mode(largest)
    p = p0 + real(mode(:n))
    v = v0 + real(mode(n + 1:))
    call begin(vehicle, 0.0_real64, p, v, past, failed)
    if (failed) return
    steps = nint(seconds/h)
    do i = 0, steps - 1
      call advance(vehicle, i*h, h, p, v, past, failed)
      if (failed) return
    end do
    growth = log(abs(dot_product(share_of, [p - p0, v - v0]))/abs(dot_product(share_of, real(mode))))/(steps*h)
  end subroutine growth_in_time

end module coach_runs
