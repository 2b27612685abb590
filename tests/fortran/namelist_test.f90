!> Scenes from namelist groups: values of every type, what is refused and how it is told.
program namelist_test
  use, intrinsic :: iso_fortran_env, only: real64
  use wrcontact, only: contact_scene, wrc_file_malformed, wrc_file_unreadable, &
    wrc_invalid_argument, wrc_ok, wrc_unknown_name
  use expectations, only: expect, finish, near, same
  implicit none

  character(*), parameter :: path = 'namelist_test.nml'
  !> A text to a number and back.
  real(real64), parameter :: rounding = 1.0e-14_real64

  call values_of_every_type_are_read()
  call groups_of_the_program_are_its_own()
  call convention_counts_from_where_it_stands()
  call namelist_and_calls_give_one_scene()
  call refusals_are_told()
  call finish()

contains

  subroutine write_file(lines)
    character(*), intent(in) :: lines(:)
    integer :: unit, i
    open (newunit=unit, file=path, status='replace', action='write')
    do i = 1, size(lines)
      write (unit, '(a)') trim(lines(i))
    end do
    close (unit)
  end subroutine write_file

  subroutine values_of_every_type_are_read()
    type(contact_scene) :: scene
    call write_file([character(80) :: &
      'A line outside of groups is a comment, it''s said.', &
      ' &TRACK gauge = 1432.5d0  ! a comment / with a slash', &
      '   Inclination = ''1:20'', rail%origin = 750.0, rail = "54E3", gauge_height =', &
      ' /', &
      ' &pose lateral=-2.5, yaw = 1e-3 roll = 2.5E-4, vertical=''solve'' /', &
      ' &material wheel%poisson = 0.28, rail%youngs_modulus = 2.0E5', &
      ' &end', &
      ' &solve grid = 2*32 threads = 1/'])
    call scene%create()
    call scene%read_namelist(path)
    call expect(near(scene%get_number('track.gauge'), 1432.5_real64, rounding), 'd exponent')
    call expect(near(scene%get_number('track.inclination'), 0.05_real64, 1.0e-3_real64), 'an inclination of 1:20')
    call expect(scene%get_text('track.rail.file') == '54E3', 'a text in double quotes')
    call expect(scene%get_text('track.rail') == '54E3; origin = 750', 'an option of a profile, before it')
    call expect(near(scene%get_number('track.gauge_height'), 14.0_real64, rounding), 'no value, no change')
    call expect(near(scene%get_number('pose.lateral'), -2.5_real64, rounding), 'a negative number')
    call expect(near(scene%get_number('pose.yaw'), 1.0e-3_real64, rounding), 'an exponent')
    call expect(near(scene%get_number('pose.roll'), 2.5e-4_real64, rounding), 'a number for a word')
    call expect(scene%get_text('pose.vertical') == 'solve', 'a word')
    call expect(near(scene%get_number('material.wheel.poisson'), 0.28_real64, rounding), 'component')
    call expect(near(scene%get_number('material.rail.youngs_modulus'), 2.0e5_real64, rounding), &
      'ended by &end')
    call expect(all(nint(scene%get_numbers('solve.grid')) == [32, 32]), 'repeated')
    call expect(same(scene%get_number('wheelset.radius'), 460.0_real64), 'not named, not changed')
  end subroutine values_of_every_type_are_read

  !> The same file serves the program's own READ and the scene's.
  subroutine groups_of_the_program_are_its_own()
    type(contact_scene) :: scene
    integer :: unit, stat
    real(real64) :: speed
    character(200) :: errmsg
    namelist /vehicle/ speed
    call write_file([character(80) :: '&vehicle speed = 30.0 /', '&pose lateral = 1.5 /'])
    open (newunit=unit, file=path, status='old', action='read')
    read (unit, nml=vehicle)
    call expect(near(speed, 30.0_real64, rounding), 'its own group')
    call scene%create()
    call scene%read_namelist(unit)
    call expect(near(scene%get_number('pose.lateral'), 1.5_real64, rounding), 'the scene''s group')
    close (unit)
    call scene%read_namelist(path, stat, errmsg)
    call expect(stat == wrc_unknown_name .and. index(errmsg, '&vehicle, line 1') > 0, &
      'a file of its own holds scenes only')
    call scene%read_namelist(77, stat)
    call expect(stat == wrc_file_unreadable, 'a unit that is not open')
  end subroutine groups_of_the_program_are_its_own

  subroutine convention_counts_from_where_it_stands()
    type(contact_scene) :: scene
    call write_file([character(80) :: '&convention units = ''SI'' /', '&pose lateral = 0.002 /'])
    call scene%create()
    call scene%read_namelist(path)
    call scene%set('convention.units', 'mm')
    call expect(near(scene%get_number('pose.lateral'), 2.0_real64, rounding), 'metres by the file')
    call write_file([character(80) :: '&pose lateral = 0.003 /'])
    call scene%set('convention.units', 'SI')
    call scene%read_namelist(path)
    call scene%set('convention.units', 'mm')
    call expect(near(scene%get_number('pose.lateral'), 3.0_real64, rounding), 'metres by the scene')
  end subroutine convention_counts_from_where_it_stands

  subroutine namelist_and_calls_give_one_scene()
    type(contact_scene) :: by_file, by_calls
    call write_file([character(80) :: '&pose lateral = 3.0 /', '&solve grid = 24, 20 /'])
    call by_file%create()
    call by_file%read_namelist(path)
    call by_file%solve()
    call by_calls%create()
    call by_calls%set('pose.lateral', 3.0_real64)
    call by_calls%set('solve.grid', [24, 20])
    call by_calls%solve()
    call expect(same(by_file%number('left.pmax'), by_calls%number('left.pmax')), 'bit for bit')
  end subroutine namelist_and_calls_give_one_scene

  subroutine refusals_are_told()
    type(contact_scene) :: scene, none
    integer :: stat
    character(300) :: errmsg
    call scene%create()
    call refuse(scene, '&pose lateral = 1.0, sideways = 2.0 /', wrc_unknown_name, 'pose.sideways')
    call refuse(scene, '&track gauge = 20.0 /', wrc_invalid_argument, '20')
    call refuse(scene, '&track gauge = wide /', wrc_file_malformed, 'gauge = wide')
    call refuse(scene, '&track gauge = 14:35 /', wrc_file_malformed, '14:35')
    call refuse(scene, '&track gauge = 1435.0', wrc_file_malformed, 'not ended by /')
    call refuse(scene, '&track rail = ''60E1 /', wrc_file_malformed, 'quote')
    call refuse(scene, '&track rail = ''60E1'' ''54E3'' /', wrc_file_malformed, 'one text')
    call refuse(scene, '&track 1435.0 /', wrc_file_malformed, 'without a name')
    call refuse(scene, '&track gauge = 0*5 /', wrc_file_malformed, '0*5')
    call refuse(scene, '&track gauge = x*5 /', wrc_file_malformed, 'x*5')
    call refuse(scene, '&trak gauge = 1435.0 /', wrc_unknown_name, '&trak')
    call refuse(scene, '&solve grid = 24 20 22 /', wrc_invalid_argument, 'solve.grid')
    call expect(same(scene%get_number('pose.lateral'), 0.0_real64), 'refused as a whole')
    call scene%read_namelist('not_there.nml', stat, errmsg)
    call expect(stat == wrc_file_unreadable .and. index(errmsg, 'not_there.nml') > 0, 'no file')
    call write_file([character(80) :: '&pose lateral = 3.0 /'])
    call none%read_namelist(path, stat, errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'NULL') > 0, 'no scene yet')
    call write_file([character(80) :: 'no group at all'])
    call scene%read_namelist(path, stat)
    call expect(stat == wrc_ok, 'nothing to set')
  end subroutine refusals_are_told

  !> The line is refused with the status, and its place and `told` are in the text.
  subroutine refuse(scene, line, expected, told)
    type(contact_scene), intent(in) :: scene
    character(*), intent(in) :: line, told
    integer, intent(in) :: expected
    character(80) :: lines(2)
    integer :: stat
    character(300) :: errmsg
    lines(1) = '! first line'
    lines(2) = line
    call write_file(lines)
    errmsg = ''
    call scene%read_namelist(path, stat, errmsg)
    call expect(stat == expected, line//' is refused, told: '//trim(errmsg))
    call expect(index(errmsg, 'line 2') > 0 .and. index(errmsg, told) > 0, &
      line//' is told, not: '//trim(errmsg))
  end subroutine refuse

end program namelist_test
