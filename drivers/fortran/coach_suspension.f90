!> Springs, dampers and bump stops of the coach, between bodies on a track that bends and twists.
!>
!> Springs and dampers are linear except for the bump stops. Static forces of the springs turn with the mean of the bodies
!> that they join (geometric stiffness), so that a body that moves sideways or rolls shifts its weight.
!>
!> Thread rule: procedures keep nothing.
module coach_suspension
  use, intrinsic :: iso_fortran_env, only: real64
  use coach_data
  use coach_track, only: track_point
  implicit none
  private
  public :: suspension, make_suspension, lay, stop_force, stop_slope, stop_energy, add_product, first_of

  integer, parameter :: n = 6*body_count

  type suspension
    real(real64) :: stiffness(n, n) = 0, damping(n, n) = 0
    real(real64) :: stops(n, 2) = 0 !< elongation of the bump stops by positions
  end type suspension

contains

  !> Index of a body's first position.
  pure integer function first_of(body)
    integer, intent(in) :: body
    first_of = 6*body - 5
  end function first_of

  subroutine make_suspension(self)
    type(suspension), intent(inout) :: self
    real(real64) :: elongation(3, n), turn(3, n), joint(3)
    integer :: i, side
    do i = 1, 4
      do side = -1, 1, 2
        joint = [places(wheelsets(i)), side*primary_side, primary_height]
        call add_spring(self, frame_of(i), wheelsets(i), joint, primary_stiffness, primary_damping, &
          primary_preload)
      end do
    end do
    do i = 1, 2
      do side = -1, 1, 2
        joint = [places(frames(i)), side*secondary_side, secondary_height]
        call add_spring(self, car, frames(i), joint, secondary_stiffness, secondary_damping, secondary_preload)
      end do
      joint = [places(frames(i)), 0.0_real64, rod_height]
      call add_spring(self, car, frames(i), joint, [rod_stiffness, 0.0_real64, 0.0_real64], &
        [rod_damping, 0.0_real64, 0.0_real64], 0.0_real64)
      turn = turn_of(car) - turn_of(frames(i))
      call add_product(self%stiffness, 2*secondary_bending + anti_roll_bar, turn(1, :), turn(1, :))
      call add_product(self%stiffness, 2*secondary_bending, turn(2, :), turn(2, :))
      joint = [places(frames(i)), 0.0_real64, stop_height]
      elongation = motion_of(car, joint) - motion_of(frames(i), joint)
      self%stops(:, i) = elongation(2, :)
    end do
    self%stiffness(1, 1) = self%stiffness(1, 1) + coupler_stiffness
    self%damping(1, 1) = self%damping(1, 1) + coupler_damping
    call drop_rounding(self%stiffness)
    call drop_rounding(self%damping)
  end subroutine make_suspension

  !> The coach is its own mirror image. Terms between y, roll or yaw and x, z or pitch therefore cancel; what rounding
  !> leaves of them goes, so that a mirrored run gives the same bits.
  pure subroutine drop_rounding(matrix)
    real(real64), intent(inout) :: matrix(n, n)
    integer :: i, j
    do j = 1, n
      do i = 1, n
        if (mod(i + j, 2) == 1) matrix(i, j) = 0
      end do
    end do
  end subroutine drop_rounding

  !> How the point of a body at a joint moves with the positions: translation + angles x lever. A wheelset turns in its
  !> axle boxes.
  pure function motion_of(body, joint) result(motion)
    integer, intent(in) :: body
    real(real64), intent(in) :: joint(3)
    real(real64) :: motion(3, n), r(3)
    integer :: at
    at = first_of(body)
    r = joint - [places(body), 0.0_real64, heights(body)]
    motion = 0
    motion(1, at) = 1
    motion(2, at + 1) = 1
    motion(3, at + 2) = 1
    motion(2:3, at + 3) = [-r(3), r(2)]
    if (body < wheelsets(1)) motion([1, 3], at + 4) = [r(3), -r(1)]
    motion(1:2, at + 5) = [-r(2), r(1)]
  end function motion_of

  pure function turn_of(body) result(turn)
    integer, intent(in) :: body
    real(real64) :: turn(3, n)
    integer :: i
    turn = 0
    do i = 1, 3
      if (i /= 2 .or. body < wheelsets(1)) turn(i, first_of(body) + 2 + i) = 1
    end do
  end function turn_of

  !> The static force acts upwards on the first body. In the frame that turns by the mean of the bodies' angles it does
  !> the work preload*(vertical elongation - roll*lateral one + pitch*longitudinal one) to second order.
  subroutine add_spring(self, upper, lower, joint, stiffness, damping, preload)
    type(suspension), intent(inout) :: self
    integer, intent(in) :: upper, lower
    real(real64), intent(in) :: joint(3), stiffness(3), damping(3), preload
    real(real64) :: elongation(3, n), turn(3, n), of_upper(3, n), of_lower(3, n)
    integer :: i
    elongation = motion_of(upper, joint) - motion_of(lower, joint)
    of_upper = turn_of(upper)
    of_lower = turn_of(lower)
    turn = (of_upper + of_lower)/2
    do i = 1, 3
      call add_product(self%stiffness, stiffness(i), elongation(i, :), elongation(i, :))
      call add_product(self%damping, damping(i), elongation(i, :), elongation(i, :))
    end do
    do i = 1, 2
      call add_product(self%stiffness, preload*(joint(3) - heights(upper)), of_upper(i, :), of_upper(i, :))
      call add_product(self%stiffness, -preload*(joint(3) - heights(lower)), of_lower(i, :), of_lower(i, :))
    end do
    call add_product(self%stiffness, preload, turn(1, :), elongation(2, :))
    call add_product(self%stiffness, preload, elongation(2, :), turn(1, :))
    call add_product(self%stiffness, -preload, turn(2, :), elongation(1, :))
    call add_product(self%stiffness, -preload, elongation(1, :), turn(2, :))
  end subroutine add_spring

  pure subroutine add_product(matrix, factor, rows, columns)
    real(real64), intent(inout) :: matrix(n, n)
    real(real64), intent(in) :: factor, rows(n), columns(n)
    integer :: i
    do i = 1, n
      matrix(:, i) = matrix(:, i) + factor*columns(i)*rows
    end do
  end subroutine add_product

  !> Where the frames of the bodies are, seen from that of the car body, and how this changes: springs join bodies
  !> across the bend and twist of the track between them.
  pure subroutine lay(here, speed, laid, rate)
    type(track_point), intent(in) :: here(body_count)
    real(real64), intent(in) :: speed
    real(real64), intent(out) :: laid(n), rate(n)
    integer :: i, at
    laid = 0
    rate = 0
    do i = 2, body_count
      at = first_of(i)
      laid(at + 3) = here(i)%cant - here(1)%cant
      laid(at + 5) = here(i)%heading - here(1)%heading
      laid(at + 1) = here(i)%offset - here(1)%offset - places(i)*here(1)%heading - heights(i)*laid(at + 3)
      rate(at + 3) = speed*(here(i)%twist - here(1)%twist)
      rate(at + 5) = speed*(here(i)%curvature - here(1)%curvature)
      rate(at + 1) = speed*(laid(at + 5) - places(i)*here(1)%curvature) - heights(i)*rate(at + 3)
    end do
  end subroutine lay

  !> Force of a bump stop at an elongation; the last piece goes on beyond the table.
  pure real(real64) function stop_force(elongation)
    real(real64), intent(in) :: elongation
    integer :: i
    i = stop_piece(elongation)
    stop_force = sign(stop_forces(i) + stop_slope(elongation)*(abs(elongation) - stop_displacements(i)), elongation)
  end function stop_force

  pure integer function stop_piece(elongation)
    real(real64), intent(in) :: elongation
    stop_piece = min(size(stop_forces) - 1, count(stop_displacements <= abs(elongation)))
  end function stop_piece

  pure real(real64) function stop_slope(elongation)
    real(real64), intent(in) :: elongation
    integer :: i
    i = stop_piece(elongation)
    stop_slope = (stop_forces(i + 1) - stop_forces(i))/(stop_displacements(i + 1) - stop_displacements(i))
  end function stop_slope

  !> Of compression, from 0.
  pure real(real64) function stop_energy(elongation)
    real(real64), intent(in) :: elongation
    integer :: i, last
    last = stop_piece(elongation)
    stop_energy = 0
    do i = 1, last - 1
      stop_energy = stop_energy + (stop_forces(i) + stop_forces(i + 1))/2* &
        (stop_displacements(i + 1) - stop_displacements(i))
    end do
    stop_energy = stop_energy + (stop_forces(last) + stop_force(elongation))/2* &
      (elongation - stop_displacements(last))
  end function stop_energy

end module coach_suspension
