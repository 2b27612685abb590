!> Data of the coach: vehicle 1 of the Manchester benchmarks.
!>
!> S. Iwnicki, Manchester Benchmarks for Rail Vehicle Simulation, Vehicle System Dynamics 30 (1998), 295-313;
!> S. Iwnicki (ed.), The Manchester Benchmarks for Rail Vehicle Simulation, 1999. The book was not at hand. Two public
!> programs that cite it agree on masses, inertias, distances and vertical stiffness and damping, except that one
!> rounds the vertical primary stiffness to 1.2 MN/m; all other values come from one of them alone.
!>
!> Simplified: dampers have no series stiffness; rails are rigid and lie where the irregularities place them.
!>
!> m, N, kg, s, rad. Bodies: car body, leading and trailing bogie frame, four wheelsets from front to back.
module coach_data
  use, intrinsic :: iso_fortran_env, only: real64
  implicit none
  public

  integer, parameter :: body_count = 7, car = 1, frames(2) = [2, 3], wheelsets(4) = [4, 5, 6, 7]
  !> The frame that a wheelset runs in.
  integer, parameter :: frame_of(4) = [2, 2, 3, 3]

  real(real64), parameter :: gravity = 9.81_real64
  real(real64), parameter :: nominal_radius = 0.46_real64
  real(real64), parameter :: half_pivot_distance = 9.5_real64, half_wheelbase = 1.28_real64

  real(real64), parameter :: masses(7) = [32000.0_real64, 2615.0_real64, 2615.0_real64, &
    1813.0_real64, 1813.0_real64, 1813.0_real64, 1813.0_real64]
  real(real64), parameter :: car_inertia(3) = [5.68e4_real64, 1.97e6_real64, 1.97e6_real64]
  real(real64), parameter :: frame_inertia(3) = [1722.0_real64, 1476.0_real64, 3067.0_real64]
  real(real64), parameter :: wheelset_inertia(3) = [1120.0_real64, 112.0_real64, 1120.0_real64]
  real(real64), parameter :: inertias(3, 7) = reshape([car_inertia, frame_inertia, frame_inertia, &
    wheelset_inertia, wheelset_inertia, wheelset_inertia, wheelset_inertia], [3, 7])
  !> Of the centres of mass: along the track from that of the car body, and nominally above the rails.
  real(real64), parameter :: places(7) = [0.0_real64, half_pivot_distance, -half_pivot_distance, &
    half_pivot_distance + half_wheelbase, half_pivot_distance - half_wheelbase, &
    -half_pivot_distance + half_wheelbase, -half_pivot_distance - half_wheelbase]
  real(real64), parameter :: heights(7) = [1.8_real64, 0.6_real64, 0.6_real64, 0.46_real64, 0.46_real64, &
    0.46_real64, 0.46_real64]

  !> Primary suspension, one axle box: along, across, vertically; its position from the track's centre line and
  !> above the rails.
  real(real64), parameter :: primary_stiffness(3) = [3.1391e7_real64, 3.884e6_real64, 1.22e6_real64]
  real(real64), parameter :: primary_damping(3) = [1.5e4_real64, 2.0e3_real64, 4.0e3_real64]
  real(real64), parameter :: primary_side = 1.0_real64, primary_height = 0.46_real64

  !> Secondary suspension, one side of a bogie. The springs act at half their height, the dampers with them.
  real(real64), parameter :: secondary_stiffness(3) = [1.6e5_real64, 1.6e5_real64, 4.3e5_real64]
  real(real64), parameter :: secondary_damping(3) = [0.0_real64, 3.2e4_real64, 2.0e4_real64]
  real(real64), parameter :: secondary_bending = 1.05e4_real64 !< about x and y
  real(real64), parameter :: secondary_side = 1.0_real64, secondary_height = 0.8275_real64
  !> Of each bogie.
  real(real64), parameter :: anti_roll_bar = 9.4e5_real64
  !> Lateral bump stop of each bogie, between car body and frame: displacements and forces.
  real(real64), parameter :: stop_height = 0.65_real64
  real(real64), parameter :: stop_displacements(10) = [0.0_real64, 0.025_real64, 0.03_real64, 0.035_real64, &
    0.04_real64, 0.045_real64, 0.05_real64, 0.055_real64, 0.06_real64, 0.065_real64]
  real(real64), parameter :: stop_forces(10) = [0.0_real64, 0.0_real64, 600.0_real64, 1760.0_real64, &
    3730.0_real64, 6870.0_real64, 11580.0_real64, 17170.0_real64, 29200.0_real64, 230000.0_real64]

  !> Traction rod of each bogie, between car body and frame, along. No source was found; chosen here.
  real(real64), parameter :: rod_stiffness = 5.0e6_real64, rod_damping = 2.5e4_real64, rod_height = 0.6_real64

  !> Between the car body and a locomotive that runs at the prescribed speed. Not of the benchmark: chosen for half a
  !> hertz and critical damping with the coach's mass.
  real(real64), parameter :: coupler_stiffness = 4.4e5_real64, coupler_damping = 2.8e5_real64

  !> Static forces: of one secondary spring, of one primary spring, of a wheelset on the rails.
  real(real64), parameter :: secondary_preload = masses(1)*gravity/4
  real(real64), parameter :: primary_preload = (masses(1)/8 + masses(2)/4)*gravity
  real(real64), parameter :: axle_load = (masses(1)/4 + masses(2)/2 + masses(4))*gravity

end module coach_data
