!> N vehicle steps through the Fortran module: set the pose, solve, read. Prints the steps, time of a
!> step, sum of what was read, and the growth of resident memory after the first tenth, at least
!> 1000 steps. vehicle_steps.f and vehicle_steps.cpp do the same steps.
!> Usage: vehicle_steps_fortran [N]
program vehicle_steps
  use, intrinsic :: iso_fortran_env, only: int64, real64
  use wrcontact, only: contact_scene, contact_solver
  implicit none
  character(20), parameter :: names(8) = [character(20) :: 'left.lateral_force', &
    'right.lateral_force', 'left.pmax', 'right.pmax', 'left.centroid.y', 'right.centroid.y', &
    'roll', 'vertical']
  real(real64), parameter :: period = 2000.0_real64, pi = acos(-1.0_real64)
  type(contact_scene) :: scene
  type(contact_solver) :: solver
  integer(int64) :: start, now, rate
  integer :: steps, i, j, early
  real(real64) :: total
  character(20) :: argument

  steps = 3000
  call get_command_argument(1, argument)
  if (argument /= '') read (argument, *) steps
  call scene%create()
  call solver%create()
  call scene%set('solve.accuracy', 1.0e-2_real64)
  total = 0.0_real64
  early = 0
  call system_clock(start, rate)
  do i = 1, steps
    call scene%set('pose.lateral', 5.0_real64*sin(2.0_real64*pi*i/period))
    call scene%set('pose.yaw', 2.0e-3_real64*cos(2.0_real64*pi*i/period))
    call solver%solve(scene)
    do j = 1, size(names)
      total = total + scene%number(names(j))
    end do
    if (i == max(steps/10, 1000)) early = resident_kb()
  end do
  call system_clock(now)
  print '(a, i0)', 'steps ', steps
  print '(a, f0.3)', 'microseconds_per_step ', 1.0e6_real64*real(now - start, real64)/ &
    real(rate, real64)/steps
  print '(a, es24.16)', 'sum ', total
  print '(a, i0)', 'resident_kb ', resident_kb()
  print '(a, i0)', 'growth_kb ', resident_kb() - early

contains

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
