!> A coach of 42 degrees of freedom: its equations of motion with the contact forces of wrcontact.
!>
!> Each body has a frame that moves along the track's centre line with it: x along the track, y to the left, z across
!> the canted plane of the rails and up. Positions are those of the centre of mass and three small angles from the
!> static state on straight track, rates are those that an observer in the frame sees:
!>
!>   p = x, y, z, roll, pitch, yaw of the car body, of both bogie frames, of the four wheelsets;   v = dp/dt
!>
!> The pitch of a wheelset is what it has turned beyond distance over nominal radius.
!>
!>   m (v' + a_0 + alpha x r + omega x (omega x r) + 2 omega x v) = springs + dampers + contact + weight
!>   I (angular v' + alpha) + omega_total x H                     = their moments
!>
!> with the acceleration a_0 of the frame's origin, its angular velocity omega = V (twist, kappa sin phi, kappa cos phi)
!> and its derivative alpha. So centrifugal, Coriolis and gyroscopic terms, cant and twist are those of a frame on a
!> line in space. Left out: products of the small angles and omega in H, slopes of the rails along the track within
!> the contact, and the height of the centre line, which does not change in a curve.
!>
!> Thread rule: one thread at a time for a coach; its wheelsets are solved on `threads` threads.
module coach_model
  use, intrinsic :: iso_fortran_env, only: real64
  use coach_data
  use coach_suspension, only: add_product, first_of, lay, make_suspension, stop_energy, stop_force, stop_slope, &
    suspension
  use coach_track, only: point_at, rails_at, track, track_point
  use wrcontact, only: contact_patch, contact_scene, contact_solver, contact_table, step_batch, wrc_load_of_axle, &
    wrc_loads_of_wheels, wrc_ok, wrc_solved_exactly, &
    wrc_table_outputs
  implicit none
  private
  public :: coach, position_count, make_coach, accelerations, centred_state, displace, speed_at, distance_at, &
    first_of, energy_of, friction_power, contact_power, wheelset_state, &
    wear_numbers

  integer, parameter :: position_count = 6*body_count, n = position_count

  type coach
    type(contact_scene) :: scenes(4)
    type(contact_solver) :: solvers(4)
    type(contact_table) :: table
    logical :: by_table = .false. !< forces are those of the table, by the solvers where it errs too much or ends
    integer :: tabled = 0, solved = 0 !< wheels since the beginning, with a table
    real(real64) :: error_sum = 0, worst_error = 0 !< errors that the table has returned, over the wheel's load
    type(track) :: line
    integer :: threads = 1
    real(real64) :: accuracy = 1.0e-2_real64 !< of contact forces; make_coach sets it
    real(real64) :: speed = 40, acceleration = 0, acceleration_time = huge(1.0_real64) !< of the locomotive
    real(real64) :: friction(2) = 0.3_real64 !< of the left and of the right wheels
    logical :: by_differences = .false. !< Jacobians
    integer :: evaluations = 0 !< of the contact of all wheelsets
    real(real64) :: rate(n) = 0 !< accelerations found last
    real(real64) :: steady_error = 0 !< largest estimate for steady creep forces, of evaluations with derivatives
    real(real64) :: height = 0 !< of the wheelsets' centres above the rail tops in the static state
    type(suspension) :: springs
    real(real64) :: inverse_mass(n) = 0
    real(real64) :: forces(6, 2, 4) = 0 !< of the last evaluation: component, side, wheelset
    real(real64) :: wear(2, 4) = 0 !< wear numbers in the last evaluation by the table: side, wheelset
    character(200) :: message = '' !< of the last failure
  end type coach

contains

  subroutine make_coach(self, accuracy, creep, standstill_speed, wheel)
    type(coach), intent(inout) :: self
    real(real64), intent(in) :: accuracy, standstill_speed
    character(*), intent(in) :: creep, wheel
    integer :: i
    self%accuracy = accuracy
    do i = 1, 4
      call self%solvers(i)%create()
      call self%scenes(i)%create()
      call self%scenes(i)%set('convention.units', 'SI')
      call self%scenes(i)%set('solve.accuracy_of', 'forces')
      call self%scenes(i)%set('solve.accuracy', accuracy)
      call self%scenes(i)%set('solve.creep', creep)
      call self%scenes(i)%set('motion.standstill_speed', standstill_speed)
      call self%scenes(i)%set('wheelset.wheel', wheel)
      call self%scenes(i)%set('friction.left', self%friction(1))
      call self%scenes(i)%set('friction.right', self%friction(2))
    end do
    do i = 1, body_count
      self%inverse_mass(first_of(i):first_of(i) + 2) = 1/masses(i)
      self%inverse_mass(first_of(i) + 3:first_of(i) + 5) = 1/inertias(:, i)
    end do
    call make_suspension(self%springs)
  end subroutine make_coach

  pure real(real64) function speed_at(self, t)
    type(coach), intent(in) :: self
    real(real64), intent(in) :: t
    speed_at = self%speed + self%acceleration*min(t, self%acceleration_time)
  end function speed_at

  !> Of the leading wheelset along the track.
  pure real(real64) function distance_at(self, t)
    type(coach), intent(in) :: self
    real(real64), intent(in) :: t
    real(real64) :: until
    until = min(t, self%acceleration_time)
    distance_at = self%speed*t + self%acceleration*until*(t - until/2)
  end function distance_at

  !> Accelerations and their derivatives. Failed: the contact could not be solved, the message says why.
  subroutine accelerations(self, t, p, v, a, failed, by_p, by_v)
    type(coach), intent(inout) :: self
    real(real64), intent(in) :: t, p(n), v(n)
    real(real64), intent(inout) :: a(n)
    logical, intent(out) :: failed
    real(real64), intent(inout), optional :: by_p(n, n), by_v(n, n)
    real(real64) :: loads(6, 4), contact_by_p(6, 6, 4), contact_by_v(6, 6, 4), laid(n), laid_rate(n), force(n)
    type(track_point) :: here(body_count)
    integer :: i, at
    do i = 1, body_count
      here(i) = point_at(self%line, distance_at(self, t) + places(i) - places(wheelsets(1)))
    end do
    if (present(by_p)) then
      call contact_loads(self, t, p, v, loads, failed, contact_by_p, contact_by_v)
    else
      call contact_loads(self, t, p, v, loads, failed)
    end if
    if (failed) return
    call lay(here, speed_at(self, t), laid, laid_rate)
    laid = laid + p
    force = -matmul(self%springs%stiffness, laid) - matmul(self%springs%damping, laid_rate + v)
    do i = 1, 2
      force = force - stop_force(dot_product(self%springs%stops(:, i), laid))*self%springs%stops(:, i)
    end do
    call add_inertia(self, t, here, p, v, force)
    do i = 1, 4
      at = first_of(wheelsets(i))
      force(at:at + 5) = force(at:at + 5) + loads(:, i)
      force(at + 2) = force(at + 2) - axle_load
    end do
    a = self%inverse_mass*force
    self%rate = a
    if (present(by_p)) call assemble_jacobian(self, speed_at(self, t), v, laid, contact_by_p, contact_by_v, &
      by_p, by_v)
  end subroutine accelerations

  !> What the motion of the frames and the cant add to the forces: weight less its static part, and inertia.
  subroutine add_inertia(self, t, here, p, v, force)
    type(coach), intent(in) :: self
    real(real64), intent(in) :: t, p(n), v(n)
    type(track_point), intent(in) :: here(body_count)
    real(real64), intent(inout) :: force(n)
    real(real64) :: speed, up(3), omega(3), alpha(3), origin(3), r(3), total(3), spin(3), rate, sine, cosine
    integer :: i, at
    speed = speed_at(self, t)
    rate = merge(self%acceleration, 0.0_real64, t < self%acceleration_time)
    do i = 1, body_count
      at = first_of(i)
      associate (q => p(at:at + 5), dq => v(at:at + 5), k => here(i))
        sine = sin(k%cant)
        cosine = cos(k%cant)
        up = [0.0_real64, -gravity*sine, gravity*(1 - cosine)]
        omega = [k%twist, k%curvature*sine, k%curvature*cosine]
        alpha = speed**2*[k%twist_rate, k%curvature_rate*sine + k%curvature*k%twist*cosine, &
          k%curvature_rate*cosine - k%curvature*k%twist*sine] + rate*omega
        origin = [rate, speed**2*k%curvature*cosine, -speed**2*k%curvature*sine]
        omega = speed*omega
        r = q(:3) + [0.0_real64, 0.0_real64, heights(i)]
        force(at:at + 2) = force(at:at + 2) + masses(i)*(up - origin - cross(alpha, r) - &
          cross(omega, cross(omega, r)) - 2*cross(omega, dq(:3)))
        total = omega + dq(4:6)
        spin = total
        if (i >= wheelsets(1)) then
          total(2) = omega(2)
          spin(2) = omega(2) + dq(5) + speed/nominal_radius
          alpha(2) = alpha(2) + rate/nominal_radius
        end if
        force(at + 3:at + 5) = force(at + 3:at + 5) - inertias(:, i)*alpha - cross(total, inertias(:, i)*spin)
      end associate
    end do
  end subroutine add_inertia

  pure function cross(a, b) result(c)
    real(real64), intent(in) :: a(3), b(3)
    real(real64) :: c(3)
    c = [a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), a(1)*b(2) - a(2)*b(1)]
  end function cross

  subroutine assemble_jacobian(self, speed, v, laid, contact_by_p, contact_by_v, by_p, by_v)
    type(coach), intent(in) :: self
    real(real64), intent(in) :: speed, v(n), laid(n), contact_by_p(6, 6, 4), contact_by_v(6, 6, 4)
    real(real64), intent(inout) :: by_p(n, n), by_v(n, n)
    real(real64) :: axle
    integer :: i, at
    by_p = -self%springs%stiffness
    by_v = -self%springs%damping
    do i = 1, 2
      associate (stop => self%springs%stops(:, i))
        call add_product(by_p, -stop_slope(dot_product(stop, laid)), stop, stop)
      end associate
    end do
    axle = wheelset_inertia(2)
    do i = 1, 4
      at = first_of(wheelsets(i))
      by_p(at:at + 5, at:at + 5) = by_p(at:at + 5, at:at + 5) + contact_by_p(:, :, i)
      by_v(at:at + 5, at:at + 5) = by_v(at:at + 5, at:at + 5) + contact_by_v(:, :, i)
      associate (roll => at + 3, pitch => at + 4, yaw => at + 5)
        by_v(roll, yaw) = by_v(roll, yaw) + axle*(speed/nominal_radius + v(pitch))
        by_v(yaw, roll) = by_v(yaw, roll) - axle*(speed/nominal_radius + v(pitch))
        by_v(roll, pitch) = by_v(roll, pitch) + axle*v(yaw)
        by_v(yaw, pitch) = by_v(yaw, pitch) - axle*v(roll)
      end associate
    end do
    do i = 1, n
      by_p(:, i) = self%inverse_mass*by_p(:, i)
      by_v(:, i) = self%inverse_mass*by_v(:, i)
    end do
  end subroutine assemble_jacobian

  !> Contact forces on the wheelsets: forces along the track, across and normal to it, moments about the axes of roll,
  !> of the axle and of yaw; their derivatives by the wheelset's positions and rates.
  subroutine contact_loads(self, t, p, v, loads, failed, by_p, by_v)
    type(coach), intent(inout) :: self
    real(real64), intent(in) :: t, p(n), v(n)
    real(real64), intent(inout) :: loads(6, 4)
    logical, intent(out) :: failed
    real(real64), intent(inout), optional :: by_p(6, 6, 4), by_v(6, 6, 4)
    real(real64) :: q(6, 4), dq(6, 4), rails(3, 2, 4), curvatures(4), total(6), onto(6, 6)
    real(real64), allocatable :: dfdq(:, :, :, :), dfdv(:, :, :, :)
    integer :: i
    do i = 1, 4
      call wheelset_state(self, t, p, v, i, q(:, i), dq(:, i), rails(:, :, i), curvatures(i))
    end do
    if (present(by_p)) allocate (dfdq(6, 6, 2, 4), dfdv(6, 6, 2, 4))
    if (present(by_p)) call set_rates(self, t)
    call step_all(self, q, dq, rails, curvatures, failed, dfdq, dfdv)
    if (failed) return
    if (present(by_p) .and. .not. (self%by_table .or. self%by_differences)) self%steady_error = &
      max(self%steady_error, largest_steady_error(self))
    do i = 1, 4
      total = sum(self%forces(:, :, i), dim=2)
      onto = work_per_motion(q(:, i))
      loads(:, i) = matmul(onto, total)
      if (.not. present(by_p)) cycle
      by_p(:, :, i) = matmul(onto, sum(dfdq(:, :, :, i), dim=3))
      by_v(:, :, i) = matmul(onto, sum(dfdv(:, :, :, i), dim=3))
      by_p(4, 6, i) = by_p(4, 6, i) + total(5)
      by_p(5, [4, 6], i) = by_p(5, [4, 6], i) + [total(6), -total(4)]
    end do
  end subroutine contact_loads

  !> Position and velocity of a wheelset, displacements of its rails and curvature, as a step has them.
  pure subroutine wheelset_state(self, t, p, v, wheelset, q, dq, rails, curvature)
    type(coach), intent(in) :: self
    real(real64), intent(in) :: t, p(n), v(n)
    integer, intent(in) :: wheelset
    real(real64), intent(out) :: q(6), dq(6), rails(3, 2), curvature
    type(track_point) :: here
    real(real64) :: s
    integer :: at
    at = first_of(wheelsets(wheelset))
    s = distance_at(self, t) + places(wheelsets(wheelset)) - places(wheelsets(1))
    q = p(at:at + 5)
    q(3) = q(3) + self%height
    dq = v(at:at + 5)
    dq(1) = dq(1) + speed_at(self, t)
    dq(5) = dq(5) + speed_at(self, t)/nominal_radius
    rails = rails_at(self%line, s)
    here = point_at(self%line, s)
    curvature = here%curvature*cos(here%cant)
  end subroutine wheelset_state

  !> How fast the track and the velocities change, from which the library finds the error of steady creep forces.
  subroutine set_rates(self, t)
    type(coach), intent(inout) :: self
    real(real64), intent(in) :: t
    real(real64), parameter :: ahead = 0.01_real64
    real(real64) :: s, slopes(3, 2)
    integer :: i, at
    do i = 1, 4
      at = first_of(wheelsets(i))
      s = distance_at(self, t) + places(wheelsets(i)) - places(wheelsets(1))
      slopes = (rails_at(self%line, s + ahead) - rails_at(self%line, s - ahead))/(2*ahead)
      call self%scenes(i)%set('track.left.slope', slopes(:, 1))
      call self%scenes(i)%set('track.right.slope', slopes(:, 2))
      call self%scenes(i)%set('motion.acceleration', self%rate(at:at + 5))
    end do
  end subroutine set_rates

  !> Over friction times load, of wheels in contact.
  real(real64) function largest_steady_error(self)
    type(coach), intent(in) :: self
    real(real64) :: error
    integer :: i, side, stat
    largest_steady_error = 0
    do i = 1, 4
      do side = 1, 2
        error = self%scenes(i)%number(trim(merge('left ', 'right', side == 1))//'.creep_steady_error', stat)
        if (stat == wrc_ok) largest_steady_error = max(largest_steady_error, error)
      end do
    end do
  end function largest_steady_error

  !> One step of each wheelset, with derivatives by the library or by differences if there is room for them.
  subroutine step_all(self, q, dq, rails, curvatures, failed, dfdq, dfdv)
    type(coach), intent(inout) :: self
    real(real64), intent(in) :: q(6, 4), dq(6, 4), rails(3, 2, 4), curvatures(4)
    logical, intent(out) :: failed
    real(real64), intent(inout), allocatable :: dfdq(:, :, :, :), dfdv(:, :, :, :)
    !> Small against the overlap of the bodies and what makes the wheels slide, large against what the iteration
    !> leaves of forces.
    real(real64), parameter :: steps(6, 2) = reshape([1.0_real64, 1.0e-5_real64, 1.0e-6_real64, &
      2.0e-6_real64, 1.0_real64, 1.0e-5_real64, 1.0e-4_real64, 1.0e-4_real64, 1.0e-4_real64, &
      1.0e-4_real64, 1.0e-4_real64, 1.0e-4_real64], [6, 2])
    real(real64) :: moved(6, 4, 2), other(6, 2, 4)
    integer :: j, k
    if (allocated(dfdq) .and. .not. self%by_differences) then
      call evaluate(self, q, dq, rails, curvatures, self%forces, failed, dfdq, dfdv)
    else
      call evaluate(self, q, dq, rails, curvatures, self%forces, failed)
    end if
    if (failed .or. .not. allocated(dfdq) .or. .not. self%by_differences) return
    dfdq = 0
    do k = 1, 2
      do j = 1, 6
        if (k == 1 .and. (j == 1 .or. j == 5)) cycle
        moved(:, :, 1) = q
        moved(:, :, 2) = dq
        moved(j, :, k) = moved(j, :, k) + steps(j, k)
        call evaluate(self, moved(:, :, 1), moved(:, :, 2), rails, curvatures, other, failed)
        if (failed) return
        if (k == 1) dfdq(:, j, :, :) = (other - self%forces)/steps(j, k)
        if (k == 2) dfdv(:, j, :, :) = (other - self%forces)/steps(j, k)
      end do
    end do
  end subroutine step_all

  !> Forces on all wheelsets, by the solvers or by the table.
  subroutine evaluate(self, q, dq, rails, curvatures, forces, failed, dfdq, dfdv)
    type(coach), intent(inout) :: self
    real(real64), intent(in) :: q(6, 4), dq(6, 4), rails(3, 2, 4), curvatures(4)
    real(real64), intent(inout) :: forces(6, 2, 4)
    logical, intent(out) :: failed
    real(real64), intent(inout), optional :: dfdq(6, 6, 2, 4), dfdv(6, 6, 2, 4)
    real(real64) :: errors(2), outputs(wrc_table_outputs, 2)
    integer :: i, stat, states(2)
    self%evaluations = self%evaluations + 1
    stat = wrc_ok
    if (.not. self%by_table) then
      call step_batch(self%solvers, self%scenes, q, dq, forces, self%threads, stat=stat, &
        errmsg=self%message, dfdq=dfdq, dfdv=dfdv, rails=rails, curvature=curvatures)
    end if
    do i = 1, merge(4, 0, self%by_table)
      if (present(dfdq)) then
        call self%table%step(q(:, i), dq(:, i), forces(:, :, i), errors, stat, self%message, self%solvers(i), &
          self%scenes(i), dfdq(:, :, :, i), dfdv(:, :, :, i), rails(:, :, i), states, curvature=curvatures(i), &
          friction=self%friction, outputs=outputs)
      else
        call self%table%step(q(:, i), dq(:, i), forces(:, :, i), errors, stat, self%message, self%solvers(i), &
          self%scenes(i), rails=rails(:, :, i), states=states, curvature=curvatures(i), friction=self%friction, &
          outputs=outputs)
      end if
      if (stat /= wrc_ok) exit
      self%wear(:, i) = outputs(1, :)
      self%tabled = self%tabled + 2
      self%solved = self%solved + count(iand(states, wrc_solved_exactly) /= 0)
      self%error_sum = self%error_sum + sum(errors)
      self%worst_error = max(self%worst_error, maxval(errors))
    end do
    failed = stat /= wrc_ok
  end subroutine evaluate

  !> Frictional work over the distance in the last evaluation, N: of the left and the right wheel, wheelset.
  function wear_numbers(self) result(wear)
    type(coach), intent(in) :: self
    real(real64) :: wear(2, 4)
    integer :: i, stat
    wear = self%wear
    if (self%by_table) return
    do i = 1, 4
      wear(1, i) = self%scenes(i)%number('left.wear_number', stat)
      if (stat /= wrc_ok) wear(1, i) = 0 ! lifted
      wear(2, i) = self%scenes(i)%number('right.wear_number', stat)
      if (stat /= wrc_ok) wear(2, i) = 0
    end do
  end function wear_numbers

  !> From forces and moments to loads: moments about the axis of roll, the axle and the vertical.
  pure function work_per_motion(q) result(onto)
    real(real64), intent(in) :: q(6)
    real(real64) :: onto(6, 6)
    integer :: i
    onto = 0
    do i = 1, 3
      onto(i, i) = 1
    end do
    onto(4, 4:5) = [1.0_real64, q(6)]
    onto(5, 4:6) = [-q(6), 1.0_real64, q(4)]
    onto(6, 6) = 1
  end function work_per_motion

  !> The state of a coach that rolls centred and freely on straight, even track at the speed of the time 0, and the
  !> height of its wheelsets there: the library's static equilibrium, in which the pitch rate is the one that needs
  !> no torque on the axle.
  subroutine centred_state(self, p, v, failed)
    type(coach), intent(inout) :: self
    real(real64), intent(out) :: p(n), v(n)
    logical, intent(out) :: failed
    real(real64) :: dfdv(6, 6, 2), q(6), dq(6)
    integer :: iteration, i, stat
    p = 0
    v = 0
    q = 0
    dq = [self%speed, 0.0_real64, 0.0_real64, 0.0_real64, self%speed/nominal_radius, 0.0_real64]
    do iteration = 1, 6
      call self%solvers(1)%equilibrium(self%scenes(1), wrc_load_of_axle, [axle_load, 0.0_real64], q, &
        self%forces(:, :, 1), dq, stat, self%message, dfdv=dfdv)
      failed = stat /= wrc_ok
      if (failed .or. .not. abs(self%speed) > 0) exit
      dq(5) = dq(5) - sum(self%forces(5, :, 1))/sum(dfdv(5, 5, :))
    end do
    self%height = q(3)
    do i = 1, 4
      v(first_of(wheelsets(i)) + 4) = dq(5) - self%speed/nominal_radius
    end do
  end subroutine centred_state

  !> Places the first wheelset sideways, where its wheels carry their static loads.
  subroutine displace(self, lateral, p, failed)
    type(coach), intent(inout) :: self
    real(real64), intent(in) :: lateral
    real(real64), intent(inout) :: p(n)
    logical, intent(out) :: failed
    real(real64) :: q(6), f(6, 2)
    integer :: at, stat
    q = [0.0_real64, lateral, self%height, 0.0_real64, 0.0_real64, 0.0_real64]
    call self%solvers(1)%equilibrium(self%scenes(1), wrc_loads_of_wheels, [axle_load, axle_load]/2, q, f, &
      stat=stat, errmsg=self%message)
    failed = stat /= wrc_ok
    at = first_of(wheelsets(1))
    p(at + 1:at + 3) = [lateral, q(3) - self%height, q(4)]
  end subroutine displace

  !> Kinetic energy of the motion in the frames and energy of the springs, on straight track. Weights and static forces
  !> of the springs cancel, except for the load of the wheelsets.
  pure real(real64) function energy_of(self, t, p, v) result(energy)
    type(coach), intent(in) :: self
    real(real64), intent(in) :: t, p(n), v(n)
    real(real64) :: rates(n), elongation
    integer :: i, at
    rates = v
    energy = 0
    do i = 1, 4
      at = first_of(wheelsets(i))
      rates(at + 4) = rates(at + 4) + speed_at(self, t)/nominal_radius
      energy = energy + axle_load*p(at + 2)
    end do
    energy = energy + sum(rates**2/self%inverse_mass)/2 + dot_product(p, matmul(self%springs%stiffness, p))/2
    do i = 1, 2
      elongation = abs(dot_product(self%springs%stops(:, i), p))
      energy = energy + stop_energy(elongation)
    end do
  end function energy_of

  !> Power of the contact forces of the last evaluation on the motion seen from the frames, and on the wheelsets'
  !> own motion over the ground, with the longitudinal force at the speed.
  pure function contact_power(self, t, p, v) result(power)
    type(coach), intent(in) :: self
    real(real64), intent(in) :: t, p(n), v(n)
    real(real64) :: power(2), total(6), rates(6)
    integer :: i, at
    power = 0
    do i = 1, 4
      at = first_of(wheelsets(i))
      total = sum(self%forces(:, :, i), dim=2)
      rates = v(at:at + 5)
      rates(5) = rates(5) + speed_at(self, t)/nominal_radius
      power = power + dot_product(matmul(work_per_motion(p(at:at + 5)), total), rates)
      power(2) = power(2) + total(1)*speed_at(self, t)
    end do
  end function contact_power

  !> Power of friction of the first wheelsets in the last evaluation, by the library.
  real(real64) function friction_power(self, wheelset_count) result(power)
    type(coach), intent(in) :: self
    integer, intent(in) :: wheelset_count
    type(contact_patch) :: patches(8)
    integer :: i, patch_count
    power = 0
    do i = 1, wheelset_count
      call self%scenes(i)%patches(patches, patch_count)
      power = power + sum(patches(:patch_count)%friction_power)
    end do
  end function friction_power

end module coach_model
