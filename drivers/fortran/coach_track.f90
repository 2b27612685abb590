!> The track of the coach: a straight with a curve in it, canted, with transitions after Bloss, and irregularities
!> drawn from a stated spectrum.
!>
!> Along the track's centre line at s: curvature kappa, positive in left-hand curves; cant angle phi about the centre
!> line, positive where the left rail is higher (in a left-hand curve it is negative). Both follow 3 xi^2 - 2 xi^3 over
!> a transition, so that the track's twist is continuous and its rate of change bounded.
!>
!> Irregularities: sums of harmonics with random phases, amplitude (2 S dOmega)^(1/2), of the German spectra of low
!> disturbance, taken as one-sided in m^2/(rad/m) (ERRI B 176):
!>
!>   alignment, both rails            S = A_a Oc^2/((O^2 + Or^2)(O^2 + Oc^2))
!>   vertical, both rails             S = A_v Oc^2/((O^2 + Or^2)(O^2 + Oc^2))
!>   cross-level, as an angle         S = A_v/b^2 Oc^2 O^2/((O^2 + Or^2)(O^2 + Oc^2)(O^2 + Os^2))
!>
!> for wavelengths of 3 to 100 m. The gauge stays constant. Random numbers come from a generator of this module, so that
!> a seed gives the same track everywhere.
!>
!> Thread rule: a track that has been made may be read from several threads.
module coach_track
  use, intrinsic :: iso_fortran_env, only: int64, real64
  implicit none
  private
  public :: track, track_point, make_track, point_at, rails_at

  real(real64), parameter :: pi = acos(-1.0_real64)
  integer, parameter :: harmonics = 40
  real(real64), parameter :: longest = 100, shortest = 3 !< wavelengths
  real(real64), parameter :: of_alignment = 2.119e-7_real64, of_height = 4.032e-7_real64 !< A_a, A_v
  real(real64), parameter :: cutoffs(3) = [0.8246_real64, 0.0206_real64, 0.4380_real64] !< Oc, Or, Os
  real(real64), parameter :: half_track = 0.75_real64 !< b
  real(real64), parameter :: run_in = 20 !< irregularities grow over these metres

  type track
    real(real64) :: radius = 0 !< positive to the left, 0: straight
    real(real64) :: cant = 0 !< height of the outer rail above the inner one, over 2 half_track
    real(real64) :: start = 60, transition = 80, circle = 120 !< lengths before and in the curve
    real(real64) :: irregularity = 1 !< factor
    logical :: mirrored = .false. !< left and right of everything
    integer :: seed = 1
    real(real64) :: wave_numbers(harmonics) = 0
    real(real64) :: amplitudes(harmonics, 3) = 0, phases(harmonics, 3) = 0 !< alignment, height, cross-level
  end type track

  !> The track at a point: curvature with its derivative, cant angle with two, heading, and the integral of the heading.
  type track_point
    real(real64) :: curvature = 0, curvature_rate = 0, cant = 0, twist = 0, twist_rate = 0
    real(real64) :: heading = 0, offset = 0
  end type track_point

contains

  !> Draws the irregularities.
  subroutine make_track(self)
    type(track), intent(inout) :: self
    real(real64) :: o(harmonics), width(harmonics), ratio, level(harmonics)
    integer(int64) :: state
    integer :: i, j
    ratio = (longest/shortest)**(1.0_real64/harmonics)
    o = [(2*pi/longest*ratio**(i - 0.5_real64), i=1, harmonics)]
    width = o*(sqrt(ratio) - 1/sqrt(ratio))
    level = cutoffs(1)**2/((o**2 + cutoffs(2)**2)*(o**2 + cutoffs(1)**2))
    self%wave_numbers = o
    self%amplitudes(:, 1) = sqrt(2*of_alignment*level*width)
    self%amplitudes(:, 2) = sqrt(2*of_height*level*width)
    self%amplitudes(:, 3) = sqrt(2*of_height/half_track**2*level*o**2/(o**2 + cutoffs(3)**2)*width)
    state = self%seed
    do j = 1, 3
      do i = 1, harmonics
        self%phases(i, j) = 2*pi*next_random(state)
      end do
    end do
  end subroutine make_track

  !> Between 0 and 1: x -> 48271 x mod 2^31 - 1 (Park & Miller 1993).
  real(real64) function next_random(state)
    integer(int64), intent(inout) :: state
    integer(int64), parameter :: factor = 48271_int64, modulus = 2147483647_int64
    state = mod(factor*state, modulus)
    next_random = real(state, real64)/real(modulus, real64)
  end function next_random

  pure type(track_point) function point_at(self, s) result(point)
    type(track), intent(in) :: self
    real(real64), intent(in) :: s
    real(real64) :: into(5), out(5), shape(5), curvature, cant
    if (.not. abs(self%radius) > 0) return
    into = ramp(s - self%start, self%transition)
    out = ramp(s - self%start - self%transition - self%circle, self%transition)
    shape = into - out
    curvature = 1/abs(self%radius)
    cant = -asin(self%cant/(2*half_track))
    if (self%radius < 0 .neqv. self%mirrored) then
      curvature = -curvature
      cant = -cant
    end if
    point%curvature = curvature*shape(1)
    point%curvature_rate = curvature*shape(2)
    point%cant = cant*shape(1)
    point%twist = cant*shape(2)
    point%twist_rate = cant*shape(3)
    point%heading = curvature*shape(4)
    point%offset = curvature*shape(5)
  end function point_at

  !> From 0 to 1 over a length: value, two derivatives, the integral and the integral of that.
  pure function ramp(s, length) result(shape)
    real(real64), intent(in) :: s, length
    real(real64) :: shape(5), x
    x = s/length
    if (x <= 0) then
      shape = 0
    else if (x < 1) then
      shape = [x**2*(3 - 2*x), 6*x*(1 - x)/length, (6 - 12*x)/length**2, length*x**3*(1 - x/2), &
        length**2*x**4*(0.25_real64 - 0.1_real64*x)]
    else
      shape = [1.0_real64, 0.0_real64, 0.0_real64, length*(x - 0.5_real64), &
        length**2*(0.15_real64 + (x - 1)*x/2)]
    end if
  end function ramp

  !> Displacements of the rails at s: lateral, vertical, roll of the left one, then of the right one.
  pure function rails_at(self, s) result(rails)
    type(track), intent(in) :: self
    real(real64), intent(in) :: s
    real(real64) :: rails(3, 2), deviations(3), share
    integer :: i
    rails = 0
    share = min(1.0_real64, max(0.0_real64, s/run_in))
    share = self%irregularity*share**2*(3 - 2*share)
    if (.not. abs(share) > 0) return
    do i = 1, 3
      deviations(i) = share*sum(self%amplitudes(:, i)*sin(self%wave_numbers*s + self%phases(:, i)))
    end do
    if (self%mirrored) deviations([1, 3]) = -deviations([1, 3])
    rails(1, :) = deviations(1)
    rails(2, 1) = deviations(2) + half_track*deviations(3)
    rails(2, 2) = deviations(2) - half_track*deviations(3)
  end function rails_at

end module coach_track
