!> What the Fortran tests expect, and how many times it was not so.
module expectations
  use, intrinsic :: iso_fortran_env, only: error_unit, real64
  implicit none
  private
  public :: expect, finish, is_nan, near, same
  integer :: failures = 0

contains

  subroutine expect(condition, what)
    logical, intent(in) :: condition
    character(*), intent(in) :: what
    if (condition) return
    failures = failures + 1
    write (error_unit, '(2a)') 'not so: ', what
  end subroutine expect

  pure elemental logical function near(value, expected, tolerance)
    real(real64), intent(in) :: value, expected, tolerance
    near = abs(value - expected) <= tolerance*abs(expected)
  end function near

  !> The same number, bit for bit.
  pure elemental logical function same(value, expected)
    real(real64), intent(in) :: value, expected
    same = value >= expected .and. value <= expected
  end function same

  !> By hand, since gfortran 12's own is of the wrong kind with -fdefault-integer-8.
  pure elemental logical function is_nan(value)
    real(real64), intent(in) :: value
    is_nan = .not. abs(value) >= 0.0_real64
  end function is_nan

  subroutine finish()
    if (failures > 0) error stop 'expectations failed'
  end subroutine finish

end module expectations
