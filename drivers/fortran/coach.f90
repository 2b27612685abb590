!> A coach on irregular track with a curve: an implicit and an explicit integrator on the contact forces of wrcontact.
!>
!> coach --help lists the options.
program coach_program
  use, intrinsic :: iso_fortran_env, only: error_unit, int64, real64
  use coach_data, only: wheelsets
  use coach_model, only: centred_state, coach, contact_power, displace, energy_of, first_of, friction_power, &
    make_coach, position_count, speed_at, wear_numbers
  use coach_output, only: open_data, print_header, print_line, print_statistics, read_state, write_data, write_state, &
    write_wheelsets
  use coach_runs, only: advance, begin, critical_speed, growth_in_time, history
  use coach_track, only: make_track
  use wrcontact, only: wrc_ok
  implicit none
  integer, parameter :: n = position_count
  type(coach) :: vehicle
  type(history) :: past
  real(real64) :: seconds = 1, h = 1.0e-3_real64, accuracy = 1.0e-2_real64
  real(real64) :: critical_accuracy = 3.0e-4_real64
  real(real64) :: lateral = 0, lateral_speed = 0, roll = 0, standstill_speed = 1.0e-3_real64
  !> Since the beginning: work of contact forces, of friction, and what dampers take.
  real(real64) :: work(4) = 0, powers(4) = 0
  character(200) :: creep = '', table = '', data = '', save_to = '', restart = '', &
    wheel = 'S1002', states = ''
  logical :: failed, with_energy = .false., critical = .false.

  vehicle%threads = 2
  call read_options()
  if (critical) accuracy = critical_accuracy
  call make_track(vehicle%line)
  call make_coach(vehicle, accuracy, trim(creep), standstill_speed, trim(wheel))
  if (table /= '') call load_table()
  if (critical) then
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
        'coach --help lists the options')
      bad = -1
      call read_run_option(option, value, bad)
      if (bad < 0) call read_vehicle_option(option, value, bad)
      if (bad < 0) call stop_with(trim(option)//': unknown option; coach --help lists the options')
      if (bad > 0) call stop_with(trim(option)//' '//trim(value)//': not an allowed value; coach --help '// &
        'lists the options')
    end do
    if (vehicle%line%seed < 1) call stop_with('--seed: a positive integer')
    if (creep == '') creep = merge('full   ', 'fastsim', table /= '')
    if (table /= '' .and. creep /= 'full') call stop_with('--creep: a table has the forces of the full theory')
    if (table /= '' .and. abs(standstill_speed - 1.0e-3_real64) > 0) call stop_with('--standstill-speed: a table '// &
      'has that of its scene (wrc_table --set motion.standstill_speed=...)')
    if (table /= '' .and. with_energy) call stop_with('--energy: a table does not say what friction takes')
  end subroutine read_options

  !> bad: 0 if the option is one of these and its value fits, positive if the value does not fit.
  subroutine read_run_option(option, value, bad)
    character(*), intent(in) :: option, value
    integer, intent(inout) :: bad
    select case (option)
    case ('--seconds')
      read (value, *, iostat=bad) seconds
    case ('--step')
      read (value, *, iostat=bad) h
    case ('--method')
      bad = merge(0, 1, any(value == [character(8) :: 'implicit', 'explicit']))
      past%explicit = value == 'explicit'
    case ('--keep')
      read (value, *, iostat=bad) past%keep
    case ('--accuracy')
      read (value, *, iostat=bad) accuracy
      critical_accuracy = accuracy
    case ('--creep')
      creep = value
      bad = 0
    case ('--table')
      table = value
      bad = 0
    case ('--threads')
      read (value, *, iostat=bad) vehicle%threads
    case ('--jacobian')
      bad = merge(0, 1, any(value == [character(11) :: 'library', 'differences']))
      vehicle%by_differences = value == 'differences'
    case ('--data')
      data = value
      bad = 0
    case ('--states')
      states = value
      bad = 0
    case ('--save')
      save_to = value
      bad = 0
    case ('--restart')
      restart = value
      bad = 0
    case ('--energy')
      with_energy = value == 'yes'
      bad = merge(0, 1, with_energy)
      past%tighter = 1.0e-3_real64 ! forces are those of the state, not of the iteration before
    case ('--critical')
      critical = value == 'yes'
      bad = merge(0, 1, critical)
    end select
  end subroutine read_run_option

  subroutine read_vehicle_option(option, value, bad)
    character(*), intent(in) :: option, value
    integer, intent(inout) :: bad
    select case (option)
    case ('--speed')
      read (value, *, iostat=bad) vehicle%speed
    case ('--acceleration')
      read (value, *, iostat=bad) vehicle%acceleration
    case ('--acceleration-time')
      read (value, *, iostat=bad) vehicle%acceleration_time
    case ('--wheel')
      wheel = value
      bad = 0
    case ('--friction')
      read (value, *, iostat=bad) vehicle%friction
    case ('--radius')
      read (value, *, iostat=bad) vehicle%line%radius
    case ('--cant')
      read (value, *, iostat=bad) vehicle%line%cant
    case ('--start')
      read (value, *, iostat=bad) vehicle%line%start
    case ('--transition')
      read (value, *, iostat=bad) vehicle%line%transition
    case ('--circle')
      read (value, *, iostat=bad) vehicle%line%circle
    case ('--irregularity')
      read (value, *, iostat=bad) vehicle%line%irregularity
    case ('--seed')
      read (value, *, iostat=bad) vehicle%line%seed
    case ('--mirror')
      vehicle%line%mirrored = value == 'yes'
      bad = merge(0, 1, vehicle%line%mirrored)
    case ('--lateral')
      read (value, *, iostat=bad) lateral
    case ('--lateral-speed')
      read (value, *, iostat=bad) lateral_speed
    case ('--roll')
      read (value, *, iostat=bad) roll
    case ('--standstill-speed')
      read (value, *, iostat=bad) standstill_speed
    end select
  end subroutine read_vehicle_option

  subroutine print_help()
    print '(a)', &
      'Runs a coach of 42 degrees of freedom over irregular track on forces and derivatives of wrcontact.', &
      'Usage: coach [OPTION VALUE]...', &
      '', &
      '  --speed 40            speed, m/s; negative: backwards', &
      '  --acceleration 0      of the locomotive from time 0, m/s2', &
      '  --acceleration-time T until this time, s; default: always', &
      '  --seconds 1           length of the run, s', &
      '  --step 1e-3           time step, s', &
      '  --method implicit     implicit, or explicit (Runge-Kutta of order 4)', &
      '  --keep 20             steps that a Jacobian serves', &
      '  --accuracy 1e-2       solve.accuracy; default with --critical: 3e-4, since slopes of forces need more', &
      '  --creep fastsim       solve.creep; full with --table', &
      '  --table FILE          forces from a table by wrc_table, where it errs less than its tolerance; else by the full', &
      '                        theory, on one thread', &
      '  --threads 2           number of threads; results do not depend on it', &
      '  --jacobian library    library, or differences', &
      '  --wheel S1002         profile of the wheels, a name or a file (wheelset.wheel)', &
      '  --friction ''0.3 0.3''  of the left and of the right wheels', &
      '  --radius 0            of the curve, m, positive to the left; 0: straight track', &
      '  --cant 0              of the curve, m over 1.5 m', &
      '  --start 60, --transition 80, --circle 120   lengths before the curve, of each transition, of the circle', &
      '  --irregularity 1      factor on the track irregularities', &
      '  --seed 1              of the irregularities', &
      '  --mirror yes          swap left and right of track and disturbance', &
      '  --lateral 0           initial lateral displacement of the first wheelset, m', &
      '  --lateral-speed 0     its initial lateral velocity, m/s', &
      '  --standstill-speed 1e-3  motion.standstill_speed, m/s; 0.1 for runs that stop or start', &
      '  --roll 0              its initial roll, rad; it then stands on one wheel', &
      '  --energy yes          print the energy balance; for straight, even track', &
      '  --data FILE           write a table of all steps, which coach.gp draws', &
      '  --states FILE         write position, velocity, rails and curvature of the wheelsets in every tenth step', &
      '  --save FILE           write the state at the end', &
      '  --restart FILE        continue from a state written by --save', &
      '  --critical yes        instead: find the critical speed by eigenvalues, and check it by runs of', &
      '                        --seconds from a disturbance of --lateral (default 5e-6)'
  end subroutine print_help

  subroutine load_table()
    integer :: stat
    call vehicle%table%load(trim(table), stat, vehicle%message)
    if (stat /= wrc_ok) call stop_with(trim(vehicle%message))
    vehicle%by_table = .true.
  end subroutine load_table

  subroutine stop_with(message)
    character(*), intent(in) :: message
    write (error_unit, '(2a)') 'coach: ', message
    stop 1
  end subroutine stop_with

  subroutine run()
    real(real64) :: p(n), v(n), start, energy, side
    real(real64), allocatable :: wheel_forces(:, :, :), wear(:, :)
    integer :: first, last, i, unit, at, unit_of_states
    integer(int64) :: began, ended, rate
    real(real64) :: processor(2)
    call centred_state(vehicle, p, v, failed)
    if (failed) call stop_with(trim(vehicle%message))
    print '(a, f10.6)', 'height of a wheelset, m              ', vehicle%height
    call print_balance()
    at = first_of(wheelsets(1))
    side = merge(-1.0_real64, 1.0_real64, vehicle%line%mirrored)
    if (abs(lateral) > 0) call displace(vehicle, side*lateral, p, failed)
    if (failed) call stop_with(trim(vehicle%message))
    v(at + 1) = side*lateral_speed
    if (abs(roll) > 0) p(at + 2:at + 3) = [0.75_real64*abs(roll), side*roll] ! it turns about the other wheel
    start = 0
    if (restart /= '') then
      call read_state(restart, start, p, v, past, failed)
      if (failed) call stop_with(trim(restart)//': not a state written by --save')
    else
      call begin(vehicle, start, p, v, past, failed)
      if (failed) call stop_with(trim(vehicle%message))
    end if
    vehicle%evaluations = 0
    energy = energy_of(vehicle, start, p, v)
    if (with_energy) powers = powers_now(start, p, v)
    if (data /= '') call open_data(data, unit)
    if (states /= '') open (newunit=unit_of_states, file=states, action='write')
    first = nint(start/h)
    last = first + nint(seconds/h)
    allocate (wheel_forces(2, 8, last - first), wear(8, last - first))
    call print_header()
    call system_clock(began, rate)
    call cpu_time(processor(1))
    do i = first, last - 1
      call advance(vehicle, i*h, h, p, v, past, failed)
      if (failed) call stop_with(trim(vehicle%message))
      wheel_forces(:, :, i + 1 - first) = reshape(vehicle%forces([2, 3], :, :), [2, 8])
      wear(:, i + 1 - first) = reshape(wear_numbers(vehicle), [8])
      if (with_energy) call add_work((i + 1)*h, p, v)
      if (data /= '') call write_data(unit, vehicle, (i + 1)*h, p)
      if (states /= '' .and. mod(i, 10) == 0) call write_wheelsets(unit_of_states, vehicle, (i + 1)*h, p, v)
      if (mod(i + 1 - first, max(1, (last - first)/10)) == 0) call print_line(vehicle, (i + 1)*h, p)
    end do
    call system_clock(ended)
    call cpu_time(processor(2))
    call print_counts(real(ended - began, real64)/real(rate, real64), processor(2) - processor(1), last - first)
    call print_statistics(wheel_forces, wear)
    if (with_energy) call print_energy(energy_of(vehicle, last*h, p, v) - energy)
    print '(a, *(es25.17))', 'state ', p, v
    if (save_to /= '') call write_state(save_to, last*h, p, v, past)
  end subroutine run

  !> Balance of a centred wheelset: no force except a drag that supplies the power of the spin.
  subroutine print_balance()
    real(real64) :: total(6)
    total = sum(vehicle%forces(:, :, 1), dim=2)
    print '(a, es12.4)', 'lateral force when centred, N        ', total(2)
    print '(a, es12.4)', 'moment about the vertical, N m       ', total(6)
    print '(a, es12.4)', 'power of its drag when centred, W    ', -total(1)*vehicle%speed
    print '(a, es12.4)', 'power of its friction, W             ', friction_power(vehicle, 1)
  end subroutine print_balance

  subroutine print_counts(taken, processor, steps)
    real(real64), intent(in) :: taken, processor
    integer, intent(in) :: steps
    print '(a, i0)', 'steps                     ', steps
    print '(a, i0)', 'steps halved              ', past%halved
    print '(a, i0)', 'Newton iterations         ', past%iterations
    print '(a, i0)', 'Jacobians                 ', past%jacobians
    print '(a, i0)', 'evaluations               ', vehicle%evaluations
    if (vehicle%by_table) then
      print '(a, f0.4)', 'wheels solved exactly, share      ', real(vehicle%solved, real64)/vehicle%tabled
      print '(a, f0.4)', 'mean error by the table           ', vehicle%error_sum/vehicle%tabled
      print '(a, f0.4)', 'largest error by the table        ', vehicle%worst_error
    end if
    if (vehicle%steady_error > 0) print '(a, f0.4)', 'largest error of steady creep forces ', vehicle%steady_error
    print '(a, f0.1)', 'microseconds per step     ', 1.0e6_real64*taken/max(1, steps)
    print '(a, f0.3)', 'wall over simulated time  ', taken/(h*max(1, steps))
    print '(a, f0.3)', 'processor over simulated time ', processor/(h*max(1, steps))
  end subroutine print_counts

  !> Of contact forces on the motion in the frames, over the ground, of friction, of dampers.
  function powers_now(t, p, v) result(now)
    real(real64), intent(in) :: t, p(n), v(n)
    real(real64) :: now(4)
    now(:2) = contact_power(vehicle, t, p, v)
    now(3) = friction_power(vehicle, 4)
    now(4) = dot_product(v, matmul(vehicle%springs%damping, v))
  end function powers_now

  subroutine add_work(t, p, v)
    real(real64), intent(in) :: t, p(n), v(n)
    real(real64) :: before(4)
    before = powers
    powers = powers_now(t, p, v)
    work = work + h*(before + powers)/2
  end subroutine add_work

  !> In the frames: kinetic energy and energy of the springs change by the work of contact forces less that of the
  !> dampers. Over the ground: contact forces take what friction dissipates, and what the contacts store.
  subroutine print_energy(gained)
    real(real64), intent(in) :: gained
    print '(a, es13.5)', 'energy gained, J                     ', gained
    print '(a, es13.5)', 'work of contact forces, J            ', work(1)
    print '(a, es13.5)', 'work that dampers take, J            ', work(4)
    print '(a, es13.5)', 'energy that is missing, J            ', gained - work(1) + work(4)
    print '(a, es13.5)', 'work that contacts take, J           ', -work(2)
    print '(a, es13.5)', 'work of friction by the library, J   ', work(3)
  end subroutine print_energy

  subroutine print_critical_speed()
    real(real64) :: growth(2), by_eigenvalues
    complex(real64) :: eigenvalues(2)
    real(real64), parameter :: around(2) = [0.98_real64, 1.02_real64]
    integer :: i
    vehicle%line%irregularity = 0
    if (.not. lateral > 0) lateral = 5.0e-6_real64
    call critical_speed(vehicle, 10.0_real64, 150.0_real64, failed)
    if (failed) call stop_with(trim(vehicle%message))
    by_eigenvalues = vehicle%speed
    print '(a)', ' speed, m/s  frequency, Hz  growth by eigenvalue, 1/s  in time, 1/s'
    do i = 1, 2
      vehicle%speed = around(i)*by_eigenvalues
      call growth_in_time(vehicle, lateral, seconds, h, past, growth(i), eigenvalues(i), failed)
      if (failed) call stop_with(trim(vehicle%message))
      print '(f11.3, f15.3, f26.4, f14.4)', vehicle%speed, aimag(eigenvalues(i))/(2*acos(-1.0_real64)), &
        real(eigenvalues(i)), growth(i)
    end do
    print '(a, f9.3)', 'critical speed by eigenvalues, m/s ', by_eigenvalues
    print '(a, f9.3)', 'critical speed in time, m/s        ', by_eigenvalues*(around(1) - growth(1)* &
      (around(2) - around(1))/(growth(2) - growth(1)))
  end subroutine print_critical_speed

end program coach_program
