!> A two-axle bogie on straight track under a car body that runs along steadily: its data, and its
!> rates of change with the contact forces of wrcontact.
!>
!> Track frame: x forward, y to the left, z up; m, N, kg, s, rad. The frame's and the wheelsets'
!> positions are those from the state in which weights and static forces of the springs balance.
!>
!>   p = y, z, roll, yaw of the first wheelset, of the second, then y, z, roll, pitch, yaw of the frame
!>   u = p, dp/dt, pitch rates of both axles
!>
!>   M p'' = -K p - C p' + contact forces - weights on the wheelsets + gyroscopic moments
!>   I_axle (pitch rate)' = moment of the contact forces about the axle
!>
!> Angles are small but in the contact, which knows them as they are. The pitch rate turns the axle
!> e = (-yaw, 1, roll); d(I_axle pitch_rate e)/dt makes the gyroscopic moments.
!>
!> Thread rule: one thread at a time for a bogie; both wheelsets are solved on `threads` threads.
module bogie_model
  use, intrinsic :: iso_fortran_env, only: real64
  use wrcontact, only: contact_scene, contact_solver, step_batch, wrc_ok
  implicit none
  private
  public :: bogie, position_count, state_count, make, rates, centred_state, speed_at, rails_at

  integer, parameter :: position_count = 13, state_count = 2*position_count + 2, frame = 8
  real(real64), parameter :: pi = acos(-1.0_real64)

  ! A bogie of the size of a passenger coach's.
  real(real64), parameter :: wheelset_mass = 1800, roll_inertia = 1100, axle_inertia = 110
  real(real64), parameter :: frame_mass = 2600, frame_inertia(3) = [1700, 1500, 3000]
  real(real64), parameter :: axle_load = 1.1e5_real64 !< on the track, weight of the wheelset included
  real(real64), parameter :: half_wheelbase = 1.28_real64
  !> Axle box: springs and dampers along, across and vertically; their position from the frame's centre, and only
  !> sideways from that of the wheelset.
  real(real64), parameter :: box_stiffness(3) = [1.2e7_real64, 4.0e6_real64, 1.2e6_real64]
  real(real64), parameter :: box_damping(3) = [1.2e4_real64, 4.0e3_real64, 1.0e4_real64]
  real(real64), parameter :: box_side = 1.0_real64, box_height = -0.1_real64
  !> One side, between frame and car body.
  real(real64), parameter :: body_stiffness(3) = [1.6e5_real64, 1.6e5_real64, 4.3e5_real64]
  real(real64), parameter :: body_damping(3) = [1.0e5_real64, 3.0e4_real64, 3.0e4_real64]
  real(real64), parameter :: body_side = 1.0_real64, body_height = 0.3_real64

  !> Irregularities: sums of harmonics, amplitudes of lateral and vertical displacement of a rail, and
  !> phases of the left and the right one. They grow over the first metres.
  real(real64), parameter :: wavelengths(4) = [26.0_real64, 11.3_real64, 6.1_real64, 3.2_real64]
  real(real64), parameter :: amplitudes(4, 2) = reshape([1.2e-3_real64, 5.0e-4_real64, 2.0e-4_real64, &
    4.0e-5_real64, 2.0e-3_real64, 8.0e-4_real64, 3.0e-4_real64, 8.0e-5_real64], [4, 2])
  real(real64), parameter :: phases(4, 2, 2) = reshape([0.0_real64, 1.0_real64, 2.5_real64, &
    4.0_real64, 0.3_real64, 1.7_real64, 3.9_real64, 5.0_real64, 0.4_real64, 1.9_real64, 2.2_real64, &
    5.5_real64, 0.1_real64, 2.6_real64, 4.4_real64, 0.7_real64], [4, 2, 2])
  real(real64), parameter :: run_in = 20

  !> States among a wheelset's numbers in a step of the library: y, z, roll, yaw.
  integer, parameter :: free(4) = [2, 3, 4, 6]

  type bogie
    type(contact_scene) :: scenes(2)
    type(contact_solver) :: solvers(2)
    integer :: threads = 1
    real(real64) :: accuracy = 1.0e-2_real64 !< of contact forces; make sets it
    real(real64) :: speed = 40, acceleration = 0 !< at the time 0; constant
    real(real64) :: irregularity = 1 !< factor of the amplitudes
    logical :: by_differences = .false. !< Jacobians
    integer :: evaluations = 0 !< of the contact of both wheelsets
    real(real64) :: height = 0 !< of the wheelsets' centres above the rail tops in the centred state
    real(real64) :: inverse_mass(position_count) = 0
    real(real64) :: stiffness(position_count, position_count) = 0
    real(real64) :: damping(position_count, position_count) = 0
    real(real64) :: forces(6, 2, 2) = 0 !< of the last evaluation: component, side, wheelset
    character(200) :: message = '' !< of the last failure
  end type bogie

contains

  subroutine make(self, accuracy, creep)
    type(bogie), intent(inout) :: self
    real(real64), intent(in) :: accuracy
    character(*), intent(in) :: creep
    real(real64), parameter :: wheelset_inertia(4) = [wheelset_mass, wheelset_mass, roll_inertia, &
      roll_inertia]
    integer :: i, side
    real(real64) :: on_wheelset(3, position_count), on_frame(3, position_count)
    self%accuracy = accuracy
    do i = 1, 2
      call self%solvers(i)%create()
      call self%scenes(i)%create()
      call self%scenes(i)%set('convention.units', 'SI')
      call self%scenes(i)%set('solve.accuracy_of', 'forces')
      call self%scenes(i)%set('solve.accuracy', accuracy)
      call self%scenes(i)%set('solve.creep', creep)
    end do
    self%inverse_mass = 1/[wheelset_inertia, wheelset_inertia, frame_mass, frame_mass, frame_inertia]
    do side = -1, 1, 2
      do i = 1, 2
        on_wheelset = motion_at(4*(i - 1), [0.0_real64, side*box_side, 0.0_real64])
        on_frame = motion_at(frame, [(3 - 2*i)*half_wheelbase, side*box_side, box_height])
        call add_spring(self, on_frame - on_wheelset, box_stiffness, box_damping)
      end do
      on_frame = motion_at(frame, [0.0_real64, side*body_side, body_height])
      call add_spring(self, on_frame, body_stiffness, body_damping)
    end do
  end subroutine make

  !> How a point of a body moves with the positions: translation + angles x position.
  pure function motion_at(body, place) result(motion)
    integer, intent(in) :: body !< before its first position
    real(real64), intent(in) :: place(3)
    real(real64) :: motion(3, position_count)
    integer :: yaw
    motion = 0
    motion(2, body + 1) = 1
    motion(3, body + 2) = 1
    motion(2:3, body + 3) = [-place(3), place(2)]
    yaw = body + 4
    if (body == frame) then
      yaw = body + 5
      motion([1, 3], body + 4) = [place(3), -place(1)]
    end if
    motion(1:2, yaw) = [-place(2), place(1)]
  end function motion_at

  subroutine add_spring(self, elongation, stiffness, damping)
    type(bogie), intent(inout) :: self
    real(real64), intent(in) :: elongation(3, position_count), stiffness(3), damping(3)
    integer :: i
    do i = 1, position_count
      self%stiffness(:, i) = self%stiffness(:, i) + matmul(stiffness*elongation(:, i), elongation)
      self%damping(:, i) = self%damping(:, i) + matmul(damping*elongation(:, i), elongation)
    end do
  end subroutine add_spring

  pure real(real64) function speed_at(self, t)
    type(bogie), intent(in) :: self
    real(real64), intent(in) :: t
    speed_at = self%speed + self%acceleration*t
  end function speed_at

  !> Displacements of the rails under both wheelsets: lateral, vertical, roll of the left one, then of
  !> the right one.
  pure function rails_at(self, t) result(rails)
    type(bogie), intent(in) :: self
    real(real64), intent(in) :: t
    real(real64) :: rails(3, 2, 2), x, share
    integer :: i, side, component
    rails = 0
    do i = 1, 2
      x = self%speed*t + 0.5_real64*self%acceleration*t**2 - 2*(i - 1)*half_wheelbase
      share = min(1.0_real64, max(0.0_real64, x/run_in))
      share = self%irregularity*share**2*(3 - 2*share)
      do side = 1, 2
        do component = 1, 2
          rails(component, side, i) = share*sum(amplitudes(:, component)*sin(2*pi*x/wavelengths + &
            phases(:, component, side)))
        end do
      end do
    end do
  end function rails_at

  !> du/dt, and its derivatives by u. Failed: the contact could not be solved, the message says why.
  subroutine rates(self, t, u, du, failed, jacobian)
    type(bogie), intent(inout) :: self
    real(real64), intent(in) :: t, u(state_count)
    real(real64), intent(inout) :: du(state_count)
    logical, intent(out) :: failed
    real(real64), intent(inout), optional :: jacobian(state_count, state_count)
    real(real64) :: loads(5, 2), by(5, 9, 2), other(5, 2), moved(state_count)
    integer :: i, j, at(9)
    if (present(jacobian) .and. .not. self%by_differences) then
      call contact_loads(self, t, u, loads, failed, by)
    else
      call contact_loads(self, t, u, loads, failed)
    end if
    do j = 1, merge(9, 0, present(jacobian) .and. self%by_differences .and. .not. failed)
      moved = u
      do i = 1, 2
        at = states_of(i)
        moved(at(j)) = moved(at(j)) + difference_step(j)
      end do
      call contact_loads(self, t, moved, other, failed)
      if (failed) exit
      by(:, j, :) = (other - loads)/difference_step(j)
    end do
    if (failed) return
    call assemble_rates(self, u, loads, du)
    if (present(jacobian)) call assemble_jacobian(self, u, by, jacobian)
  end subroutine rates

  !> Small against the overlap of the bodies and what makes the wheels slide, large against what the
  !> iteration leaves of forces.
  pure real(real64) function difference_step(j)
    integer, intent(in) :: j
    real(real64), parameter :: steps(9) = [1.0e-5_real64, 1.0e-6_real64, 2.0e-6_real64, 1.0e-5_real64, &
      1.0e-4_real64, 1.0e-4_real64, 1.0e-4_real64, 1.0e-4_real64, 1.0e-4_real64]
    difference_step = steps(j)
  end function difference_step

  !> Indices in u of y, z, roll, yaw, their rates and the pitch rate of a wheelset.
  pure function states_of(wheelset) result(at)
    integer, intent(in) :: wheelset
    integer :: at(9), i
    at(:4) = [(4*(wheelset - 1) + i, i=1, 4)]
    at(5:8) = at(:4) + position_count
    at(9) = 2*position_count + wheelset
  end function states_of

  !> Contact forces on the wheelsets: along y and z, moments of roll, yaw and about the axle; their
  !> derivatives by states_of.
  subroutine contact_loads(self, t, u, loads, failed, by)
    type(bogie), intent(inout) :: self
    real(real64), intent(in) :: t, u(state_count)
    real(real64), intent(inout) :: loads(5, 2)
    logical, intent(out) :: failed
    real(real64), intent(inout), optional :: by(5, 9, 2)
    real(real64) :: q(6, 2), v(6, 2), rails(3, 2, 2), dfdq(6, 6, 2, 2), dfdv(6, 6, 2, 2), total(6), &
      onto(5, 6)
    integer :: i, at(9), stat
    q = 0
    v = 0
    do i = 1, 2
      at = states_of(i)
      q(free, i) = u(at(:4))
      q(3, i) = q(3, i) + self%height
      v(free, i) = u(at(5:8))
      v(1, i) = speed_at(self, t)
      v(5, i) = u(at(9))
    end do
    rails = rails_at(self, t)
    self%evaluations = self%evaluations + 1
    if (present(by)) then
      call step_batch(self%solvers, self%scenes, q, v, self%forces, self%threads, stat=stat, &
        errmsg=self%message, dfdq=dfdq, dfdv=dfdv, rails=rails)
    else
      call step_batch(self%solvers, self%scenes, q, v, self%forces, self%threads, stat=stat, &
        errmsg=self%message, rails=rails)
    end if
    failed = stat /= wrc_ok
    if (failed) return
    do i = 1, 2
      total = sum(self%forces(:, :, i), dim=2)
      onto = work_per_motion(q(:, i))
      loads(:, i) = matmul(onto, total)
      if (.not. present(by)) cycle
      by(:, :4, i) = matmul(onto, sum(dfdq(:, free, :, i), dim=3))
      by(:, 5:8, i) = matmul(onto, sum(dfdv(:, free, :, i), dim=3))
      by(:, 9, i) = matmul(onto, sum(dfdv(:, 5, :, i), dim=2))
      by(3, 4, i) = by(3, 4, i) + total(5)
      by(5, 3:4, i) = by(5, 3:4, i) + [total(6), -total(4)]
    end do
  end subroutine contact_loads

  !> From forces and moments to the loads along y and z, about the axis of roll, the vertical one and
  !> the axle.
  pure function work_per_motion(q) result(onto)
    real(real64), intent(in) :: q(6)
    real(real64) :: onto(5, 6)
    onto = 0
    onto(1, 2) = 1
    onto(2, 3) = 1
    onto(3, 4:5) = [1.0_real64, q(6)]
    onto(4, 6) = 1
    onto(5, 4:6) = [-q(6), 1.0_real64, q(4)]
  end function work_per_motion

  subroutine assemble_rates(self, u, loads, du)
    type(bogie), intent(in) :: self
    real(real64), intent(in) :: u(state_count), loads(5, 2)
    real(real64), intent(inout) :: du(state_count)
    real(real64) :: force(position_count)
    integer :: i, at(9)
    associate (p => u(:position_count), dp => u(position_count + 1:2*position_count))
      force = -matmul(self%stiffness, p) - matmul(self%damping, dp)
      do i = 1, 2
        at = states_of(i)
        force(at(:4)) = force(at(:4)) + loads(:4, i)
        force(at(2)) = force(at(2)) - axle_load
        force(at(3)) = force(at(3)) + axle_inertia*u(at(9))*dp(at(4))
        force(at(4)) = force(at(4)) - axle_inertia*u(at(9))*dp(at(3))
        du(at(9)) = loads(5, i)/axle_inertia
      end do
      du(:position_count) = dp
    end associate
    du(position_count + 1:2*position_count) = self%inverse_mass*force
  end subroutine assemble_rates

  subroutine assemble_jacobian(self, u, by, jacobian)
    type(bogie), intent(in) :: self
    real(real64), intent(in) :: u(state_count), by(5, 9, 2)
    real(real64), intent(inout) :: jacobian(state_count, state_count)
    integer, parameter :: n = position_count
    integer :: i, j, at(9)
    jacobian = 0
    do j = 1, n
      jacobian(j, n + j) = 1
      jacobian(n + 1:2*n, j) = -self%stiffness(:, j)
      jacobian(n + 1:2*n, n + j) = -self%damping(:, j)
    end do
    do i = 1, 2
      at = states_of(i)
      jacobian(at(5:9), at) = jacobian(at(5:9), at) + by(:, :, i)
      associate (roll => at(7), yaw => at(8), pitch => at(9))
        jacobian(roll, yaw) = jacobian(roll, yaw) + axle_inertia*u(pitch)
        jacobian(yaw, roll) = jacobian(yaw, roll) - axle_inertia*u(pitch)
        jacobian(roll, pitch) = jacobian(roll, pitch) + axle_inertia*u(yaw)
        jacobian(yaw, pitch) = jacobian(yaw, pitch) - axle_inertia*u(roll)
        jacobian(pitch, :) = jacobian(pitch, :)/axle_inertia
      end associate
    end do
    do j = 1, state_count
      jacobian(n + 1:2*n, j) = self%inverse_mass*jacobian(n + 1:2*n, j)
    end do
  end subroutine assemble_jacobian

  !> The state of a bogie that rolls centred and freely at the speed of the time 0, and the height of
  !> its wheelsets there.
  subroutine centred_state(self, u, failed)
    type(bogie), intent(inout) :: self
    real(real64), intent(inout) :: u(state_count)
    logical, intent(out) :: failed
    real(real64) :: loads(5, 2), by(5, 9, 2)
    integer :: iteration, stat
    u = 0
    call self%scenes(1)%set('load.vertical', axle_load/2)
    call self%solvers(1)%solve(self%scenes(1), stat, self%message)
    failed = stat /= wrc_ok
    if (failed) return
    self%height = self%scenes(1)%number('vertical') - self%scenes(1)%number('left.depth')
    u(2*position_count + 1:) = self%speed/self%height
    do iteration = 1, 6
      call contact_loads(self, 0.0_real64, u, loads, failed, by)
      if (failed) return
      self%height = self%height - (loads(2, 1) - axle_load)/by(2, 2, 1)
      u(2*position_count + 1:) = u(2*position_count + 1:) - loads(5, :)/by(5, 9, :)
    end do
  end subroutine centred_state

end module bogie_model
