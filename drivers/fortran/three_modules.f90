!> The paper's workflow, module by module: contact geometry, remesh, contact mechanics.
!>
!> Scenes of the paper's Table 1 (S1002 on UIC60 inclined 1:40), displacements of its Table 2, left
!> wheel. Geometry finds the roll and the point of first touch; remesh samples the vertical distance
!> on 256 x 128 equally spaced elements; mechanics presses that distance together, here as any
!> distance of a program's own would be. The load is not printed in the paper; 80 kN along the
!> distances fits. The same scene solved in one call, which samples the distance where the wheel has
!> sunk to and not where it first touches, is printed beside. Times are those of this run in ms;
!> the paper states 8.25 s for one case of this size, on its computer.
program three_modules
  use, intrinsic :: iso_fortran_env, only: int64, real64
  use wrcontact, only: contact_scene, library_version, normal_contact
  implicit none

  real(real64), parameter :: load = 80.0e3_real64
  integer, parameter :: lateral_count = 256, longitudinal_count = 128
  real(real64), parameter :: lateral(6) = [-5, -3, -1, 1, 3, 5]
  !> MPa; the paper's Table 2, "the present model" and "results from [7]" (CONTACT).
  real(real64), parameter :: paper(6) = [1115, 1010, 852, 1165, 1470, 2150]
  real(real64), parameter :: paper_contact(6) = [1093, 1030, 829, 1220, 1495, 2278]

  type :: contact_case
    real(real64) :: roll, touch, pmax, pmax_at_once
    real(real64) :: geometry_ms, remesh_ms, mechanics_ms
  end type contact_case

  type(contact_case) :: cases(6)
  integer :: i

  do i = 1, size(lateral)
    cases(i) = solved(lateral(i))
  end do
  call print_tables()

contains

  type(contact_case) function solved(y) result(found)
    real(real64), intent(in) :: y
    type(contact_scene) :: scene
    type(normal_contact) :: normal
    real(real64), allocatable :: distance(:, :)
    integer(int64) :: start

    call scene%create()
    call scene%set('solve.side', 'left')
    call scene%set('solve.method', 'paper')
    call scene%set('solve.grid', [lateral_count, longitudinal_count])
    call scene%set('load.both', load)
    call scene%set('load.of', 'normal')
    call scene%set('pose.lateral', y)

    call scene%set('solve.until', 'geometry')
    call start_clock(start)
    call scene%solve()
    found%geometry_ms = elapsed_ms(start)
    found%roll = scene%number('roll')
    found%touch = scene%number('left.rigid_contact.s_wheel')

    call scene%set('solve.until', 'remesh')
    call start_clock(start)
    call scene%solve()
    distance = scene%field_2d('left.undeformed_distance')
    found%remesh_ms = elapsed_ms(start)

    call start_clock(start)
    call normal%create()
    call normal%set_grid(lateral_count, longitudinal_count, scene%number('left.element_size.lateral'), &
      scene%number('left.element_size.longitudinal'))
    call normal%set_distance(distance)
    call normal%set('solver', 'paper')
    call normal%set('normal_load', load)
    call normal%solve()
    found%pmax = normal%number('pmax')
    found%mechanics_ms = elapsed_ms(start)

    call scene%set('solve.until', 'mechanics')
    call scene%solve()
    found%pmax_at_once = scene%number('left.pmax')
  end function solved

  subroutine start_clock(start)
    integer(int64), intent(out) :: start
    call system_clock(start)
  end subroutine start_clock

  real(real64) function elapsed_ms(start)
    integer(int64), intent(in) :: start
    integer(int64) :: now, rate
    call system_clock(now, rate)
    elapsed_ms = 1.0e3_real64*real(now - start, real64)/real(rate, real64)
  end function elapsed_ms

  subroutine print_tables()
    type(contact_scene) :: scene
    character(*), parameter :: header = '(/, a, t36, 6i9)', row = '(a, t36, 6f9.1)'
    call scene%create()
    print '(2a)', 'wrcontact ', library_version()
    print '(/, a)', 'Table 1: calculation parameters'
    print '(a, t36, 4a)', 'wheel/rail', scene%get_text('wheelset.wheel'), '/', &
      scene%get_text('track.rail')
    print '(a, t36, f0.1)', 'track gauge, mm', scene%get_number('track.gauge')
    print '(a, t36, f6.4)', 'rail inclination, rad', scene%get_number('track.inclination')
    print '(a, t36, f0.1)', 'inner gauge of the wheelset, mm', &
      scene%get_number('wheelset.back_to_back')
    print '(a, t36, f0.1)', 'wheel radius, mm', scene%get_number('wheelset.radius')
    print '(a, t36, f0.1)', 'tread to internal face, mm', scene%get_number('wheelset.tape_offset')
    print '(a, t36, f0.1)', 'Young''s modulus, GPa', &
      scene%get_number('material.youngs_modulus')/1.0e3_real64
    print '(a, t36, f4.2)', 'Poisson''s ratio', scene%get_number('material.poisson')

    print header, 'Table 2: largest pressure, y in mm', nint(lateral)
    print row, 'paper, results from [7], MPa', paper_contact
    print row, 'paper, the present model, MPa', paper
    print row, 'three modules, MPa', cases%pmax
    print row, 'in one call, MPa', cases%pmax_at_once
    print row, 'three modules against paper, %', 100.0_real64*(cases%pmax/paper - 1.0_real64)
    print '(a, t36, 6f9.4)', 'roll, mrad', 1.0e3_real64*cases%roll
    print '(a, t36, 6f9.3)', 'first touch on wheel, mm', cases%touch

    print header, 'Time of a case of 256 x 128, ms', nint(lateral)
    print '(a, t36, 6f9.2)', 'geometry', cases%geometry_ms
    print '(a, t36, 6f9.2)', 'geometry again and remesh', cases%remesh_ms
    print '(a, t36, 6f9.2)', 'mechanics', cases%mechanics_ms
    print '(a, t36, 6f9.2)', 'total', cases%geometry_ms + cases%remesh_ms + cases%mechanics_ms
  end subroutine print_tables

end program three_modules
