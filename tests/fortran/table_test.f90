!> The progress of a table, counted.
module counted_calls
  use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_int32_t, c_ptr
  implicit none

contains

  integer(c_int32_t) function count_calls(context, fraction) bind(C)
    type(c_ptr), value :: context
    real(c_double), value :: fraction
    integer, pointer :: calls
    call c_f_pointer(context, calls)
    calls = calls + 1
    count_calls = 0
    if (fraction > 1.0_c_double) count_calls = 1
  end function count_calls

end module counted_calls

!> Tables of contact forces in the Fortran module.
program table_test
  use, intrinsic :: iso_c_binding, only: c_funloc, c_funptr, c_loc
  use, intrinsic :: iso_fortran_env, only: real64
  use wrcontact
  use counted_calls
  use expectations
  implicit none

  call table_has_the_forces_of_a_step()
  call finish()

contains

  subroutine table_has_the_forces_of_a_step()
    type(contact_table) :: table, other, again
    type(contact_scene) :: scene
    type(contact_solver) :: solver
    type(table_facts) :: known
    real(real64) :: q(6), v(6), f(6, 2), exact(6, 2), error(2), dfdq(6, 6, 2), dfdr(6, 3, 2), far(6)
    real(real64) :: likely(2, 2), outputs(wrc_table_outputs, 2), output_errors(wrc_table_outputs, 2)
    integer :: states(2), stat, i
    integer, target :: calls
    type(c_funptr) :: progress
    character(200) :: errmsg
    call scene%create()
    call solver%create()
    call scene%set('solve.accuracy_of', 'forces')
    call scene%set('solve.accuracy', 0.01_real64)
    calls = 0
    progress = c_funloc(count_calls)
    call table%build(scene, lateral=1.0_real64, roll=0.003_real64, yaw=0.01_real64, load=1.2e5_real64, &
      fineness=0.2_real64, threads=2, progress=progress, context=c_loc(calls))
    call expect(calls > 10, 'progress is called')
    call table%facts(known)
    call expect(table%line(1) == 'wheelset.wheel = S1002', 'what it is of')
    call expect(table%line(99) == '', 'no line')
    call expect(known%states > 100 .and. known%worst_error > known%median_error, 'facts of a table')

    q = [0.0_real64, 0.2_real64, 0.0_real64, 0.0_real64, 0.0_real64, 2.0e-3_real64]
    v = [2.0e4_real64, 10.0_real64, 0.0_real64, 0.0_real64, 43.5_real64, 0.0_real64]
    call solver%equilibrium(scene, wrc_load_of_axle, [1.2e5_real64, 0.0_real64], q, exact, v)
    call table%step(q, v, f, error, dfdq=dfdq, dfdr=dfdr, states=states)
    do i = 1, 2
      call expect(all(abs(f(1:3, i) - exact(1:3, i)) <= 6.0e4_real64*error(i)), 'a step within its error')
      call expect(error(i) > 0 .and. states(i) == 0, 'error and states')
      call expect(all(abs(dfdr(:, 2, i) + dfdq(:, 3, i)) <= 1.0e-6_real64*abs(dfdq(:, 3, i)) + 1.0_real64), &
        'a rail that sinks is a wheel that rises')
    end do
    call table%step(q, v, f, error, likely_errors=likely, outputs=outputs, output_errors=output_errors)
    call expect(all(likely(1, :) > 0 .and. likely(1, :) <= error), 'likely errors')
    call expect(table_output_name(1) == 'wear_number', 'the name of an output')
    call expect(table_output_name(99) == '', 'no output')
    call expect(all(outputs(1, :) > 0 .and. output_errors(1, :) > 0), 'outputs')
    call expect(all(abs(outputs(6, :) + outputs(7, :) - f(3, :)) < 0.01_real64*f(3, :)), 'forces of the lobes')
    far = q
    call table%equilibrium(wrc_loads_of_wheels, [5.0e4_real64, 7.0e4_real64], far, f, v)
    call expect(all(abs(f(3, :) - [5.0e4_real64, 7.0e4_real64]) < 0.1_real64), 'equilibrium by a table')
    far = q
    far(6) = 0.02_real64
    call table%step(far, v, f, stat=stat, errmsg=errmsg)
    call expect(stat == wrc_invalid_argument .and. index(errmsg, 'yaw') > 0, 'outside is refused')
    call table%step(far, v, f, error, solver=solver, scene=scene, states=states)
    call expect(states(1) == wrc_solved_exactly .and. abs(error(1)) <= 0, 'outside is solved')

    call table%share(other)
    call table%save('small.table')
    call again%load('small.table')
    call table%step(q, v, exact)
    call other%step(q, v, f)
    call expect(all(abs(f - exact) <= 0), 'a shared table')
    call again%step(q, v, f)
    call expect(all(abs(f - exact) <= 0), 'a table from its file')
    call again%load('no.table', stat=stat, errmsg=errmsg)
    call expect(stat == wrc_file_unreadable .and. index(errmsg, 'no.table') > 0, 'a file that is missing')
  end subroutine table_has_the_forces_of_a_step

end program table_test
