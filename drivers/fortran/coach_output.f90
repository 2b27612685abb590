!> What a run of the coach prints and writes: lines, statistics of wheel forces, a table of all steps, its state.
module coach_output
  use, intrinsic :: iso_fortran_env, only: real64
  use coach_data, only: frames, wheelsets
  use coach_model, only: coach, distance_at, first_of, position_count, wear_numbers, wheelset_state
  use coach_runs, only: history
  use coach_track, only: point_at, rails_at, track_point
  implicit none
  private
  public :: open_data, write_data, print_header, print_line, print_statistics, read_state, write_state, &
    write_wheelsets

  integer, parameter :: n = position_count

contains

  subroutine open_data(path, unit)
    character(*), intent(in) :: path
    integer, intent(out) :: unit
    open (newunit=unit, file=path, action='write')
    write (unit, '(a)') '# 1 t, s; 2 distance of the leading wheelset, m; 3-6 y of the wheelsets, 7-8 of the bogie &
      &frames, 9 of the car body, m; 10 its roll, rad; 11-14 Q of the first wheelset, left and right, of the second, &
      &N; 15-18 Y; 19-21 alignment, height of the left and the right rail under the first wheelset, m; 22 curvature &
      &of the track, 1/m; 23 cant angle, rad; 24-27 wear number (frictional work over distance), N; 28-31 Y/Q, &
      &positive away from the track; both as Q'
  end subroutine open_data

  subroutine write_data(unit, vehicle, t, p)
    integer, intent(in) :: unit
    type(coach), intent(in) :: vehicle
    real(real64), intent(in) :: t, p(n)
    real(real64) :: rails(3, 2), wear(2, 4)
    type(track_point) :: here
    integer :: i
    here = point_at(vehicle%line, distance_at(vehicle, t))
    wear = wear_numbers(vehicle)
    rails = rails_at(vehicle%line, distance_at(vehicle, t))
    write (unit, '(*(es15.7))') t, distance_at(vehicle, t), (p(first_of(wheelsets(i)) + 1), i=1, 4), &
      (p(first_of(frames(i)) + 1), i=1, 2), p([2, 4]), vehicle%forces(3, :, :2), vehicle%forces(2, :, :2), &
      rails(1, 1), rails(2, :), here%curvature, here%cant, wear(:, :2), &
      (quotient(vehicle%forces(:, :, i)), i=1, 2)
    if (modulo(nint(1.0e4_real64*t), 2000) == 0) flush (unit)
  end subroutine write_data

  !> A line for each wheelset: position, velocity, displacements of the rails, curvature, as a step has them.
  subroutine write_wheelsets(unit, vehicle, t, p, v)
    integer, intent(in) :: unit
    type(coach), intent(in) :: vehicle
    real(real64), intent(in) :: t, p(n), v(n)
    real(real64) :: q(6), dq(6), rails(3, 2), curvature
    integer :: i
    do i = 1, 4
      call wheelset_state(vehicle, t, p, v, i, q, dq, rails, curvature)
      write (unit, '(*(es24.16))') q, dq, rails, curvature
    end do
  end subroutine write_wheelsets

  !> Y/Q of the left and the right wheel, 0 without a load.
  pure function quotient(forces)
    real(real64), intent(in) :: forces(6, 2)
    real(real64) :: quotient(2)
    quotient = 0
    where (forces(3, :) > 0) quotient = [-1, 1]*forces(2, :)/forces(3, :)
  end function quotient

  subroutine print_header()
    print '(a)', '                  first wheelset                                       car body'
    print '(a)', '       t, s    y, mm  yaw, mrad    Q, kN    Q, kN    Y, kN    Y, kN    y, mm  roll, mrad'
  end subroutine print_header

  subroutine print_line(vehicle, t, p)
    type(coach), intent(in) :: vehicle
    real(real64), intent(in) :: t, p(n)
    integer :: at
    at = first_of(wheelsets(1))
    print '(f11.4, f9.3, f11.4, 4f9.2, f9.2, f12.3)', t, 1.0e3_real64*p([at + 1, at + 5]), &
      1.0e-3_real64*vehicle%forces(3, :, 1), 1.0e-3_real64*vehicle%forces(2, :, 1), 1.0e3_real64*p([2, 4])
  end subroutine print_line

  !> Of Y and Q, as they are in each step, not filtered: of the wheels of the first wheelset, and of all.
  subroutine print_statistics(forces, wear)
    real(real64), intent(in) :: forces(:, :, :) !< Y and Q, wheel, step
    real(real64), intent(in) :: wear(:, :) !< wear number by wheel and step
    character(*), parameter :: names(3) = [character(12) :: 'first left', 'first right', 'all wheels']
    real(real64), allocatable :: y(:), q(:)
    real(real64) :: mean
    integer :: i, first, last
    if (size(forces, 3) == 0) return
    print '(a)', 'kN               mean Q  rms Q - mean  99.85 % of Q  least Q    rms Y  99.85 % of |Y|'
    do i = 1, 3
      first = merge(1, i, i == 3)
      last = merge(size(forces, 2), i, i == 3)
      y = 1.0e-3_real64*reshape(forces(1, first:last, :), [size(forces(1, first:last, :))])
      q = 1.0e-3_real64*reshape(forces(2, first:last, :), [size(y)])
      mean = sum(q)/size(q)
      print '(a, f11.4, 2f14.4, f9.4, f9.4, f16.4)', names(i), mean, sqrt(sum((q - mean)**2)/size(q)), &
        quantile(q, 0.9985_real64), minval(q), sqrt(sum(y**2)/size(y)), quantile(abs(y), 0.9985_real64)
    end do
    print '(a)', 'mean wear number, N; 99.85 % of it; 99.85 % of |Y/Q| under a load'
    do i = 1, 3
      first = merge(1, i, i == 3)
      last = merge(size(forces, 2), i, i == 3)
      q = reshape(forces(2, first:last, :), [size(forces(2, first:last, :))])
      y = abs(reshape(forces(1, first:last, :), [size(q)]))/max(q, 1.0_real64)
      print '(a, 2f11.3, f10.4)', names(i), sum(wear(first:last, :))/size(wear(first:last, :)), &
        quantile(reshape(wear(first:last, :), [size(q)]), 0.9985_real64), quantile(pack(y, q > 1), 0.9985_real64)
    end do
  end subroutine print_statistics

  !> The least value that the share of the values does not exceed, by bisection.
  pure real(real64) function quantile(values, share)
    real(real64), intent(in) :: values(:), share
    real(real64) :: below, middle
    below = minval(values) - 1
    quantile = maxval(values)
    do
      middle = (below + quantile)/2
      if (.not. (middle > below .and. middle < quantile)) exit
      if (count(values <= middle) >= share*size(values)) then
        quantile = middle
      else
        below = middle
      end if
    end do
  end function quantile

  !> All that a run goes on from; the vehicle is that of the options.
  subroutine write_state(path, t, p, v, past)
    character(*), intent(in) :: path
    real(real64), intent(in) :: t, p(n), v(n)
    type(history), intent(in) :: past
    integer :: unit
    open (newunit=unit, file=path, form='unformatted', access='stream', status='replace')
    write (unit) t, p, v, past%a, past%f, past%matrix, past%step, past%rate, past%pivots, past%age
    close (unit)
  end subroutine write_state

  subroutine read_state(path, t, p, v, past, failed)
    character(*), intent(in) :: path
    real(real64), intent(inout) :: t, p(n), v(n)
    type(history), intent(inout) :: past
    logical, intent(out) :: failed
    integer :: unit, bad
    open (newunit=unit, file=path, form='unformatted', access='stream', status='old', iostat=bad)
    if (bad == 0) read (unit, iostat=bad) t, p, v, past%a, past%f, past%matrix, past%step, past%rate, &
      past%pivots, past%age
    failed = bad /= 0
    if (.not. failed) close (unit)
  end subroutine read_state

end module coach_output
