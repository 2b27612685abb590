! Solves the scenes of a file and prints their warnings, as a program with the module reads them.
! Lines of the file: as in warnings_c.c.
program warnings_module
  use, intrinsic :: iso_fortran_env, only: real64
  use wrcontact
  implicit none
  type(contact_scene) :: scene
  character(1024) :: path, line, name
  character(128) :: word, key
  real(real64) :: pair(2)
  integer :: unit, end, i, stat
  call get_command_argument(1, path)
  open (newunit=unit, file=path, action='read', status='old')
  do
    read (unit, '(a)', iostat=end) line
    if (end /= 0) exit
    word = next()
    key = next()
    select case (word)
    case ('scene')
      call scene%create()
      name = key
    case ('number')
      read (line, *) pair(1)
      call scene%set(trim(key), pair(1))
    case ('list')
      read (line, *) pair
      call scene%set(trim(key), pair)
    case ('text')
      call scene%set(trim(key), trim(line))
    case default
      call scene%solve(stat)
      if (stat /= wrc_ok .and. stat /= wrc_not_converged) error stop 'not solved'
      if (scene%warning_count() /= nint(scene%number('warning_count'))) error stop 'count'
      do i = 1, scene%warning_count()
        print '(3a)', trim(name), char(9), scene%warning(i)
      end do
      if (scene%warning(scene%warning_count() + 1) /= '') error stop 'past the end'
    end select
  end do
contains
  !> The first word of the line, which loses it.
  function next() result(taken)
    character(128) :: taken
    integer :: length
    length = index(line, ' ')
    taken = line(:length)
    line = adjustl(line(length:))
  end function next
end program warnings_module
