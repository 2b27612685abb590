!> Time integration and stability of a bogie.
!>
!> SDIRK of order 2 with two stages, L-stable (Alexander 1977): with g = 1 - 1/sqrt(2)
!>
!>   k1 = f(t + g h, u + g h k1),   k2 = f(t + h, u + (1 - g) h k1 + g h k2)
!>   u(t + h) = u + h ((1 - g) k1 + g k2)
!>
!> Newton's iteration for each k with the matrix 1 - g h df/du, LU factors by LAPACK. The Jacobian is
!> that of the first iteration of a step, recomputed if a correction is not a tenth of the one before.
module bogie_runs
  use, intrinsic :: iso_fortran_env, only: real64
  use bogie_model, only: bogie, position_count, state_count, rates, centred_state
  implicit none
  private
  public :: history, advance, least_stable_mode, critical_speed, growth_in_time

  real(real64), parameter :: g = 1 - sqrt(0.5_real64)
  integer, parameter :: n = state_count, max_iterations = 12, max_halvings = 10
  !> Tolerance of corrections, in m, rad, m/s, rad/s, over the accuracy of contact forces: these then follow from the
  !> state to some hundredths of their uncertainty, 10 N of 160 kN at 1e-2.
  real(real64), parameter :: tolerance = 1.0e-6_real64
  !> Velocities change creep forces less than positions normal ones: by 6e5 N s/m at 40 m/s, instead of
  !> 1e9 N/m.
  real(real64), parameter :: weights(n) = [spread(1.0_real64, 1, position_count), &
    spread(1.0e-3_real64, 1, position_count), spread(1.0e-3_real64, 1, 2)]

  !> What a run has taken, and what it goes on from.
  type history
    real(real64) :: last_rate(n) = 0 !< k2 of the last step, from which the next one begins
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

  !> Over a step h from the time t; one in which the iteration fails is taken in two halves.
  recursive subroutine advance(vehicle, t, h, u, past, failed, halvings)
    type(bogie), intent(inout) :: vehicle
    real(real64), intent(in) :: t, h
    real(real64), intent(inout) :: u(n)
    type(history), intent(inout) :: past
    logical, intent(out) :: failed
    integer, intent(in), optional :: halvings
    integer :: depth, half
    depth = 0
    if (present(halvings)) depth = halvings
    call take_step(vehicle, t, h, u, past, failed)
    if (.not. failed .or. depth >= max_halvings) return
    past%halved = past%halved + 1
    do half = 0, 1
      call advance(vehicle, t + half*h/2, h/2, u, past, failed, depth + 1)
      if (failed) return
    end do
  end subroutine advance

  !> On failure u and the last rate stay.
  subroutine take_step(vehicle, t, h, u, past, failed)
    type(bogie), intent(inout) :: vehicle
    real(real64), intent(in) :: t, h
    real(real64), intent(inout) :: u(n)
    type(history), intent(inout) :: past
    logical, intent(out) :: failed
    real(real64) :: matrix(n, n), k(n), known(n)
    integer :: pivots(n)
    logical :: fresh
    fresh = .false.
    k = past%last_rate
    call solve_stage(vehicle, t + g*h, g*h, u, k, matrix, pivots, fresh, past, failed)
    if (failed) return
    known = u + (1 - g)*h*k
    call solve_stage(vehicle, t + h, g*h, known, k, matrix, pivots, fresh, past, failed)
    if (failed) return
    u = known + g*h*k
    past%last_rate = k
    past%steps = past%steps + 1
  end subroutine take_step

  !> k = f(t, known + step k) from the k given. Factors of the matrix are kept if they are there.
  subroutine solve_stage(vehicle, t, step, known, k, matrix, pivots, factored, past, failed)
    type(bogie), intent(inout) :: vehicle
    real(real64), intent(in) :: t, step, known(n)
    real(real64), intent(inout) :: k(n), matrix(n, n)
    integer, intent(inout) :: pivots(n)
    logical, intent(inout) :: factored
    type(history), intent(inout) :: past
    logical, intent(out) :: failed
    real(real64) :: rate(n), correction(n, 1), size, previous
    integer :: iteration, i, info
    previous = huge(previous)
    do iteration = 1, max_iterations
      if (factored) then
        call rates(vehicle, t, known + step*k, rate, failed)
      else
        call rates(vehicle, t, known + step*k, rate, failed, matrix)
      end if
      if (failed) return
      past%iterations = past%iterations + 1
      if (.not. factored) then
        past%jacobians = past%jacobians + 1
        matrix = -step*matrix
        do i = 1, n
          matrix(i, i) = matrix(i, i) + 1
        end do
        call dgetrf(n, n, matrix, n, pivots, info)
        factored = .true.
      end if
      correction(:, 1) = rate - k
      call dgetrs('N', n, 1, matrix, n, pivots, correction, n, info)
      k = k + correction(:, 1)
      size = maxval(abs(step*correction(:, 1))*weights)
      if (size <= tolerance*vehicle%accuracy) return
      factored = size <= 0.1_real64*previous
      previous = size
    end do
    failed = .true.
    vehicle%message = 'Newton''s iteration does not converge'
  end subroutine solve_stage

  !> The oscillation about the centred state, linearised with the Jacobian, that decays least: eigenvalue in 1/s,
  !> motion, and the left eigenvector that gives its amplitude in any motion.
  subroutine least_stable_mode(vehicle, u, eigenvalue, mode, share, failed)
    type(bogie), intent(inout) :: vehicle
    real(real64), intent(inout) :: u(n) !< the centred state
    complex(real64), intent(out) :: eigenvalue, mode(n), share(n)
    logical, intent(out) :: failed
    real(real64) :: jacobian(n, n), rate(n), re(n), im(n), left(n, n), right(n, n), work(20*n)
    integer :: i, info
    eigenvalue = 0
    mode = 0
    share = 0
    call centred_state(vehicle, u, failed)
    if (failed) return
    call rates(vehicle, 0.0_real64, u, rate, failed, jacobian)
    if (failed) return
    call dgeev('V', 'V', n, jacobian, n, re, im, left, n, right, n, work, size(work), info)
    i = maxloc(re, 1, im > 1)
    eigenvalue = cmplx(re(i), im(i), real64)
    mode = cmplx(right(:, i), right(:, i + 1), real64)
    share = cmplx(left(:, i), left(:, i + 1), real64)
  end subroutine least_stable_mode

  !> Speed at which the least stable oscillation neither grows nor decays, by bisection between two.
  subroutine critical_speed(vehicle, slow, fast, failed)
    type(bogie), intent(inout) :: vehicle
    real(real64), intent(in) :: slow, fast
    logical, intent(out) :: failed
    real(real64) :: bounds(2), u(n)
    complex(real64) :: eigenvalue, mode(n), share(n)
    bounds = [slow, fast]
    failed = .false.
    do while (bounds(2) - bounds(1) > 1.0e-3_real64*bounds(1) .and. .not. failed)
      vehicle%speed = sum(bounds)/2
      call least_stable_mode(vehicle, u, eigenvalue, mode, share, failed)
      bounds(merge(2, 1, real(eigenvalue) > 0)) = vehicle%speed
    end do
  end subroutine critical_speed

  !> Rate at which the least stable oscillation grows in time, 1/s, over some seconds, and what its
  !> eigenvalue says.
  subroutine growth_in_time(vehicle, amplitude, seconds, h, growth, eigenvalue, failed)
    type(bogie), intent(inout) :: vehicle
    real(real64), intent(in) :: amplitude !< m, of the first wheelset
    real(real64), intent(in) :: seconds, h
    real(real64), intent(out) :: growth
    complex(real64), intent(out) :: eigenvalue
    logical, intent(out) :: failed
    real(real64) :: u(n), centred(n)
    complex(real64) :: mode(n), share(n)
    type(history) :: past
    integer :: i, steps
    growth = 0
    call least_stable_mode(vehicle, centred, eigenvalue, mode, share, failed)
    if (failed) return
    mode = mode*amplitude/mode(1)
    u = centred + real(mode)
    past%last_rate = real(eigenvalue*mode)
    steps = nint(seconds/h)
    do i = 0, steps - 1
      call advance(vehicle, i*h, h, u, past, failed)
      if (failed) return
    end do
    growth = log(abs(dot_product(share, u - centred))/abs(dot_product(share, real(mode))))/(steps*h)
  end subroutine growth_in_time

end module bogie_runs
