program wheel_on_rail
  use wrcontact, only: contact_scene
  implicit none
  type(contact_scene) :: scene
  call scene%create()
  call scene%set('pose.lateral', 3.0d0)
  call scene%solve()
  print '(f0.13)', scene%number('left.pmax')
end program wheel_on_rail
