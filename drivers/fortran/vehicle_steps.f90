!> N vehicle steps through the Fortran module: 12 inputs set by id, solve, 60 results read by id.
!> Prints the steps, time of a step, sum of eight results, the growth of resident memory after the
!> first tenth, at least 1000 steps, and the median time of setting and reading without solving.
!> vehicle_steps.f and vehicle_steps.cpp do the same.
!> Usage: vehicle_steps_fortran [N]
program vehicle_steps
  use, intrinsic :: iso_fortran_env, only: int64, real64
  use wrcontact, only: contact_scene, contact_solver
  implicit none
  character(*), parameter :: input_names(12) = [character(20) :: 'pose.lateral', 'pose.yaw', &
    'load.left', 'load.right', 'friction.left', 'friction.right', 'motion.speed', &
    'motion.lateral', 'motion.yaw', 'motion.roll', 'motion.vertical', 'motion.curvature']
  !> Those that are added up.
  character(*), parameter :: summed_names(8) = [character(20) :: 'left.lateral_force', &
    'right.lateral_force', 'left.pmax', 'right.pmax', 'left.centroid.y', 'right.centroid.y', &
    'roll', 'vertical']
  !> Names per wheel.
  character(*), parameter :: other_names(26) = [character(34) :: 'total.force.x', &
    'total.force.y', 'total.force.z', 'total.moment.x', 'total.moment.y', 'total.moment.z', &
    'patch_count', 'normal_force', 'vertical_force', 'depth', 'angle', 'approach', 'centroid.x', &
    'centroid.z', 'centroid.s_wheel', 'centroid.rolling_radius', 'patches.0.normal_force', &
    'patches.0.angle', 'patches.0.x', 'patches.0.y', 'patches.0.z', 'patches.0.pmax', &
    'patches.0.approach', 'patches.0.semi_axes.longitudinal', 'patches.0.semi_axes.lateral', &
    'patches.0.coupling_weight']
  real(real64), parameter :: period = 2000.0_real64, pi = acos(-1.0_real64)
  type(contact_scene) :: scene
  type(contact_solver) :: solver
  integer(int64) :: start, now, rate
  integer :: steps, i, early, input_ids(12), result_ids(60)
  real(real64) :: total, inputs(12), results(60)
  character(20) :: argument

  steps = 3000
  call get_command_argument(1, argument)
  if (argument /= '') read (argument, *) steps
  call scene%create()
  call solver%create()
  call scene%set('solve.accuracy', 1.0e-2_real64)
  call scene%set('solve.creep', 'none')
  input_ids = [(scene%key_id(input_names(i)), i=1, 12)]
  result_ids = [(scene%number_id(summed_names(i)), i=1, 8), &
    (scene%number_id('left.'//other_names(i)), i=1, 26), &
    (scene%number_id('right.'//other_names(i)), i=1, 26)]
  inputs = 0.0_real64
  inputs(3:7) = [8.0e4_real64, 8.0e4_real64, 0.3_real64, 0.3_real64, 2.0e4_real64]
  total = 0.0_real64
  early = 0
  call system_clock(start, rate)
  do i = 1, steps
    inputs(1) = 5.0_real64*sin(2.0_real64*pi*i/period)
    inputs(2) = 2.0e-3_real64*cos(2.0_real64*pi*i/period)
    call scene%set_numbers_by_id(input_ids, inputs)
    call solver%solve(scene)
    call scene%numbers_by_id(result_ids, results)
    total = total + sum(results(:8))
    if (i == max(steps/10, 1000)) early = resident_kb()
  end do
  call system_clock(now)
  print '(a, i0)', 'steps ', steps
  print '(a, f0.3)', 'microseconds_per_step ', 1.0e6_real64*real(now - start, real64)/ &
    real(rate, real64)/steps
  print '(a, es24.16)', 'sum ', total
  print '(a, i0)', 'resident_kb ', resident_kb()
  print '(a, i0)', 'growth_kb ', resident_kb() - early
  print '(a, i0)', 'nanoseconds_per_exchange ', nint(exchange_time())

contains

  !> Median time of setting the inputs and reading the results, in ns.
  real(real64) function exchange_time()
    integer, parameter :: rounds = 100
    real(real64) :: times(1001)
    integer :: k, fastest
    do k = 1, size(times)
      call system_clock(start)
      do i = 1, rounds
        call scene%set_numbers_by_id(input_ids, inputs)
        call scene%numbers_by_id(result_ids, results)
      end do
      call system_clock(now)
      times(k) = 1.0e9_real64*real(now - start, real64)/real(rate, real64)/rounds
    end do
    do k = 1, 500
      fastest = minloc(times, 1)
      times(fastest) = huge(times)
    end do
    exchange_time = minval(times)
  end function exchange_time

  integer function resident_kb()
    integer :: unit, failed
    character(80) :: line
    resident_kb = 0
    open (newunit=unit, file='/proc/self/status', action='read', iostat=failed)
    do while (failed == 0)
      read (unit, '(a)', iostat=failed) line
      if (line(:6) == 'VmRSS:') read (line(7:index(line, 'kB') - 1), *) resident_kb
    end do
    close (unit)
  end function resident_kb

end program vehicle_steps
