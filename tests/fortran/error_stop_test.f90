!> Without `stat` a failure ends the program with the text.
program error_stop_test
  use, intrinsic :: iso_fortran_env, only: output_unit, real64
  use wrcontact, only: contact_scene
  implicit none
  type(contact_scene) :: scene
  call scene%create()
  call scene%set('pose.sideways', 1.0_real64)
  write (output_unit, '(a)') 'went on'
end program error_stop_test
