!> A program of an earlier version: old names of results and of members of a patch.
program old_program
  use, intrinsic :: iso_fortran_env, only: real64
  use expectations, only: expect, finish, same
  use wrcontact, only: contact_patch, contact_scene, rolling_contact
  implicit none
  type(contact_scene) :: scene
  type(contact_patch) :: patches(8)
  type(rolling_contact) :: rolling
  real(real64) :: pressure(4, 4)
  integer :: patch_count

  call scene%create()
  call scene%set('solve.grid', [24, 20])
  call scene%set('load.both', 70.0e3_real64)
  call scene%set('creepage.left', [1.0e-3_real64, 5.0e-4_real64, 2.0e-4_real64])
  call scene%solve()
  call expect(nint(scene%number('left.grid.0')) == 24, 'rows')
  call expect(nint(scene%number('left.patches.0.grid.1')) == 20, 'columns')
  call expect(same(scene%number('left.patches.0.semi_axes.0'), &
    scene%number('left.patches.0.semi_axes.longitudinal')), 'along')
  call expect(same(scene%number('left.patches.0.radii.1'), &
    scene%number('left.patches.0.radii.lateral')), 'across')
  call expect(same(scene%number('left.patches.0.closeness'), 0.0_real64), 'one patch')
  call expect(scene%number_id('left.moment.x') == scene%number_id('left.pressure_moment.x'), 'an id')
  call expect(scene%number('left.sensitivities.vertical_force.vertical') < 0, 'a stiffness')

  call scene%patches(patches, patch_count)
  call expect(patch_count == 2, 'two patches')
  call expect(same(patches(1)%largest_pressure, patches(1)%pmax), 'pressure')
  call expect(same(patches(1)%contact_angle, patches(1)%angle), 'angle')
  call expect(same(patches(1)%longitudinal_creep_force, patches(1)%creep_force_longitudinal), 'force')
  call expect(same(patches(1)%spin_creepage, patches(1)%creepage_spin), 'spin')
  call expect(same(patches(1)%longitudinal_semi_axis, patches(1)%semi_axes_longitudinal), 'axis')

  call rolling%create()
  call rolling%set_grid(4, 4, 1.0_real64, 1.0_real64)
  pressure = 100.0_real64
  call rolling%set_pressure(pressure)
  call rolling%set('longitudinal_creepage', -1.0e-3_real64)
  call rolling%solve()
  call expect(rolling%number('longitudinal_force') > 0, 'driving')
  call expect(same(rolling%number('longitudinal_force'), rolling%number('creep_force.longitudinal')), &
    'the same')
  call finish()
end program old_program
