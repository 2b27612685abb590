!> A bogie on irregular track: an implicit integrator on forces and derivatives of wrcontact.
!>
!> bogie --help lists the options.
program bogie_program
  use, intrinsic :: iso_fortran_env, only: error_unit, int64, real64
  use bogie_model, only: bogie, position_count, state_count, make, centred_state, speed_at, rails_at
  use wrcontact, only: contact_patch
  use bogie_runs, only: history, advance, critical_speed, growth_in_time
  implicit none
  integer, parameter :: n = state_count
  type(bogie) :: vehicle
  type(history) :: past
  real(real64) :: seconds = 1, h = 1.0e-3_real64, accuracy = 1.0e-2_real64
  real(real64) :: critical_accuracy = 3.0e-4_real64
  real(real64) :: lateral = 0, lateral_speed = 0, roll = 0
  character(200) :: creep = 'fastsim', jacobian = 'library', data = '', save_to = '', restart = ''
  character(200) :: critical = ''
  logical :: failed

  vehicle%threads = 2
  call read_options()
  vehicle%by_differences = jacobian == 'differences'
  if (critical == 'yes') accuracy = critical_accuracy
  call make(vehicle, accuracy, trim(creep))
  if (critical == 'yes') then
    call print_critical_speed()
  else
    call run()
  end if

contains

  subroutine read_options()
    character(200) :: option, value
    integer :: i, bad
    do i = 1, command_argument_count(), 2
      call get_command_argument(i, option)
      if (option == '--help' .or. option == '-h') then
        call print_help()
        stop
      end if
      call get_command_argument(i + 1, value)
      if (value == '' .and. option(:2) == '--') call stop_with(trim(option)//': a value must follow; '// &
        'bogie --help lists the options')
      bad = 0
      select case (option)
      case ('--speed')
        read (value, *, iostat=bad) vehicle%speed
      case ('--acceleration')
        read (value, *, iostat=bad) vehicle%acceleration
      case ('--seconds')
        read (value, *, iostat=bad) seconds
      case ('--step')
        read (value, *, iostat=bad) h
      case ('--accuracy')
        read (value, *, iostat=bad) accuracy
        critical_accuracy = accuracy
      case ('--creep')
        creep = value
      case ('--threads')
        read (value, *, iostat=bad) vehicle%threads
      case ('--jacobian')
        jacobian = value
        bad = merge(0, 1, any(value == [character(11) :: 'library', 'differences']))
      case ('--irregularity')
        read (value, *, iostat=bad) vehicle%irregularity
      case ('--lateral')
        read (value, *, iostat=bad) lateral
      case ('--lateral-speed')
        read (value, *, iostat=bad) lateral_speed
      case ('--roll')
        read (value, *, iostat=bad) roll
      case ('--data')
        data = value
      case ('--save')
        save_to = value
      case ('--restart')
        restart = value
      case ('--critical')
        critical = value
        bad = merge(0, 1, value == 'yes')
      case default
        call stop_with(trim(option)//': unknown option; bogie --help lists the options')
      end select
      if (bad /= 0) call stop_with(trim(option)//' '//trim(value)//': not an allowed value; bogie --help '// &
        'lists the options')
    end do
  end subroutine read_options

  subroutine print_help()
    print '(a)', &
      'Runs a bogie over irregular track with an implicit integrator on forces and derivatives of wrcontact.', &
      'Usage: bogie [OPTION VALUE]...', &
      '', &
      '  --speed 40            speed, m/s; negative: backwards', &
      '  --acceleration 0      longitudinal acceleration from time 0, m/s2', &
      '  --seconds 1           length of the run, s', &
      '  --step 1e-3           time step, s', &
      '  --accuracy 1e-2       solve.accuracy; default with --critical: 3e-4, since slopes of forces need more', &
      '  --creep fastsim       solve.creep', &
      '  --threads 2           number of threads; results do not depend on it', &
      '  --jacobian library    library, or differences', &
      '  --irregularity 1      factor on the track irregularities', &
      '  --lateral 0           initial lateral displacement of the first wheelset, m', &
      '  --lateral-speed 0     its initial lateral velocity, m/s', &
      '  --roll 0              its initial roll, rad; it then stands on one wheel', &
      '  --data FILE           write a table of all steps, which bogie.gp draws', &
      '  --save FILE           write the state at the end', &
      '  --restart FILE        continue from a state written by --save', &
      '  --critical yes        instead: find the critical speed by eigenvalues, and check it by runs of', &
      '                        --seconds from a disturbance of --lateral (default 5e-6)'
  end subroutine print_help

  subroutine stop_with(message)
    character(*), intent(in) :: message
    write (error_unit, '(2a)') 'bogie: ', message
    stop 1
  end subroutine stop_with

  subroutine run()
    real(real64) :: u(n), start
    integer :: first, last, i, unit
    integer(int64) :: began, ended, rate
    call centred_state(vehicle, u, failed)
    if (failed) call stop_with(trim(vehicle%message))
    print '(a, f10.6)', 'height of a wheelset, m              ', vehicle%height
    call print_balance()
    u(1) = lateral
    u(position_count + 1) = lateral_speed
    u(3) = roll
    u(2) = 0.75_real64*abs(roll) ! it turns about the other wheel
    start = 0
    if (restart /= '') call read_state(start, u)
    vehicle%evaluations = 0
    if (data /= '') open (newunit=unit, file=data, action='write')
    if (data /= '') write (unit, '(a)') '# t, s; x, m; y, yaw of the first wheelset, of the second, y of &
      &the frame, m, rad; vertical, then lateral forces on the left and the right wheel of the first &
      &wheelset, of the second, N; lateral and vertical displacement of the left rail, of the right one &
      &under the first wheelset, m'
    print '(a)', '       t, s    y, mm  yaw, mrad    y, mm  yaw, mrad    Q, kN    Y, kN    Q, kN    Y, kN'
    first = nint(start/h)
    last = first + nint(seconds/h)
    call system_clock(began, rate)
    do i = first, last - 1
      call advance(vehicle, i*h, h, u, past, failed)
      if (failed) call stop_with(trim(vehicle%message))
      if (data /= '') call write_line(unit, (i + 1)*h, u)
      if (mod(i + 1 - first, max(1, (last - first)/10)) == 0) print '(f11.4, 2(f9.3, f11.4), 4f9.2)', &
        (i + 1)*h, 1.0e3_real64*u([1, 4, 5, 8]), 1.0e-3_real64*vehicle%forces([3, 2], :, 1)
    end do
    call system_clock(ended)
    print '(a, i0)', 'steps                     ', past%steps
    print '(a, i0)', 'steps halved              ', past%halved
    print '(a, i0)', 'Newton iterations         ', past%iterations
    print '(a, i0)', 'Jacobians                 ', past%jacobians
    print '(a, i0)', 'evaluations               ', vehicle%evaluations
    print '(a, f0.1)', 'microseconds per step     ', 1.0e6_real64*real(ended - began, real64)/ &
      real(rate, real64)/max(1, past%steps)
    print '(a, *(es25.17))', 'state ', u
    if (save_to /= '') call write_state(last*h, u)
  end subroutine run

  !> Balance of the first wheelset of a centred bogie: no force except a drag that supplies the power of the spin.
  subroutine print_balance()
    type(contact_patch) :: patches(8)
    real(real64) :: total(6), power
    integer :: count
    call vehicle%scenes(1)%patches(patches, count)
    total = sum(vehicle%forces(:, :, 1), dim=2)
    power = sum(patches(:count)%friction_power)
    print '(a, es12.4)', 'lateral force when centred, N        ', total(2)
    print '(a, es12.4)', 'moment about the vertical, N m       ', total(6)
    print '(a, es12.4)', 'power of its drag when centred, W    ', -total(1)*vehicle%speed
    print '(a, es12.4)', 'power of its friction, W             ', power
  end subroutine print_balance

  subroutine write_line(unit, t, u)
    integer, intent(in) :: unit
    real(real64), intent(in) :: t, u(n)
    real(real64) :: rails(3, 2, 2)
    rails = rails_at(vehicle, t)
    write (unit, '(*(es15.7))') t, vehicle%speed*t + 0.5_real64*vehicle%acceleration*t**2, &
      u([1, 4, 5, 8, 9]), vehicle%forces(3, :, :), vehicle%forces(2, :, :), rails(:2, :, 1)
  end subroutine write_line

  !> All that a run goes on from; the vehicle is that of the options.
  subroutine write_state(t, u)
    real(real64), intent(in) :: t, u(n)
    integer :: unit
    open (newunit=unit, file=save_to, form='unformatted', access='stream', status='replace')
    write (unit) t, u, past%last_rate
    close (unit)
  end subroutine write_state

  subroutine read_state(t, u)
    real(real64), intent(inout) :: t, u(n)
    integer :: unit, bad
    open (newunit=unit, file=restart, form='unformatted', access='stream', status='old', iostat=bad)
    if (bad == 0) read (unit, iostat=bad) t, u, past%last_rate
    if (bad /= 0) call stop_with(trim(restart)//': not a state written by --save')
    close (unit)
  end subroutine read_state

  subroutine print_critical_speed()
    real(real64) :: growth(2), by_eigenvalues
    complex(real64) :: eigenvalues(2)
    real(real64), parameter :: around(2) = [0.98_real64, 1.02_real64]
    integer :: i
    vehicle%irregularity = 0
    if (.not. lateral > 0) lateral = 5.0e-6_real64
    call critical_speed(vehicle, 10.0_real64, 150.0_real64, failed)
    if (failed) call stop_with(trim(vehicle%message))
    by_eigenvalues = vehicle%speed
    print '(a)', ' speed, m/s  frequency, Hz  growth by eigenvalue, 1/s  in time, 1/s'
    do i = 1, 2
      vehicle%speed = around(i)*by_eigenvalues
      call growth_in_time(vehicle, lateral, seconds, h, growth(i), eigenvalues(i), failed)
      if (failed) call stop_with(trim(vehicle%message))
      print '(f11.3, f15.3, f26.4, f14.4)', vehicle%speed, aimag(eigenvalues(i))/(2*acos(-1.0_real64)), &
        real(eigenvalues(i)), growth(i)
    end do
    print '(a, f9.3)', 'critical speed by eigenvalues, m/s ', by_eigenvalues
    print '(a, f9.3)', 'critical speed in time, m/s        ', by_eigenvalues*(around(1) - growth(1)* &
      (around(2) - around(1))/(growth(2) - growth(1)))
  end subroutine print_critical_speed

end program bogie_program
