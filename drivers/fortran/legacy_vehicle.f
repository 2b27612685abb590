c A wheelset hunting along straight track: an old vehicle program that
c calls wrcontact every time step through the F77 layer.
c
c Model: two degrees of freedom, lateral displacement y (to the left)
c and yaw psi, of a wheelset that runs at constant speed v, held to a
c steady frame by a lateral and a yaw spring (free in the first run):
c
c   m y"    = F_y - k_y y
c   Iz psi" = M_z - k_psi psi
c
c F_y, M_z: of all contact forces of both wheels, normal and creep
c forces, about the wheelset's centre. The library finds roll and
c height, contact points, patches, creepages from the motion, the speed
c of the axle that runs freely, and creep forces (Shen, Hedrick &
c Elkins 1983 on Kalker's coefficients) at every evaluation. Not
c modelled: inertia in roll, bounce and pitch (80 kN stay on each
c wheel), velocity of roll in the creepages.
c
c Integrator: Heun's method (explicit trapezium, two evaluations a
c step of 1.5 or 2 ms). Creep damps the lateral velocity at a rate of
c about 2 G a b C22/(m v), 0.6/ms at 20 m/s: within the method's limit
c of 2 a step.
c
c Runs: (1) free, slow and at low amplitude: the wavelength is that of
c Klingel's formula with the equivalent conicity at that amplitude;
c (2) with springs, below the critical speed: the motion dies away;
c (3) above it: it grows to a limit cycle between the gauge corners.
      program legveh
      implicit none
      real*8 mass, inert, ky, kpsi, v
      common /veh/ mass, inert, ky, kpsi, v
      real*8 conic, lambda, ampl, wave, first, last
      mass = 1500.0d0
      inert = 900.0d0

      call opened
      write (*, '(a)') 'A wheelset on straight track'
c     Free and slow.
      ky = 0.0d0
      kpsi = 0.0d0
      v = 20.0d0
      call run(1.0d-3, 1.5d-3, 500, .false., ampl, wave, first, last)
      call klingl(ampl, conic, lambda)
      write (*, '(/a)') '1. Free wheelset, 20 m/s'
      write (*, 10) 'amplitude, mm', 1.0d3*ampl
      write (*, 10) 'equivalent conicity', conic
      write (*, 10) 'wavelength by Klingel, m', lambda
      write (*, 10) 'wavelength of the motion, m', wave

      ky = 1.0d6
      kpsi = 1.5d6
      v = 40.0d0
      write (*, '(/a)') '2. With springs, 40 m/s'
      call run(3.0d-3, 2.0d-3, 500, .true., ampl, wave, first, last)
      write (*, 10) 'largest in the first half, mm', 1.0d3*first
      write (*, 10) 'largest in the second half, mm', 1.0d3*last

      v = 60.0d0
      write (*, '(/a)') '3. With springs, 60 m/s'
      call run(3.0d-3, 2.0d-3, 1000, .true., ampl, wave, first, last)
      write (*, 10) 'largest in the first half, mm', 1.0d3*first
      write (*, 10) 'largest in the second half, mm', 1.0d3*last
      call closed
   10 format (a, t36, f10.4)
      end

c Scene and solver of the wheelset, made once; keys and results that
c every step needs, by number.
      subroutine opened
      implicit none
      integer*8 scene, solver
      integer keys(5), forces(2)
      common /wrc/ scene, solver, keys, forces
      integer ierr
      call wrcopn(scene, 'scene', kind(0), 1.0d0, ierr)
      call wanted(ierr)
      call wrcopn(solver, 'solver', kind(0), 1.0d0, ierr)
      call wanted(ierr)
      call wrcset(scene, 'solve.accuracy', 1.0d-2, ierr)
      call wanted(ierr)
      call wrcstx(scene, 'solve.accuracy_of', 'forces', ierr)
      call wanted(ierr)
      call wrcstx(scene, 'solve.creep', 'shen-hedrick-elkins', ierr)
      call wanted(ierr)
      call wrcset(scene, 'load.both', 80.0d3, ierr)
      call wanted(ierr)
      call wrcstx(scene, 'motion.pitch', 'free', ierr)
      call wanted(ierr)
      call wrckid(scene, 'pose.lateral', keys(1), ierr)
      call wanted(ierr)
      call wrckid(scene, 'pose.yaw', keys(2), ierr)
      call wanted(ierr)
      call wrckid(scene, 'motion.speed', keys(3), ierr)
      call wanted(ierr)
      call wrckid(scene, 'motion.lateral', keys(4), ierr)
      call wanted(ierr)
      call wrckid(scene, 'motion.yaw', keys(5), ierr)
      call wanted(ierr)
      call wrcnid(scene, 'wheelset.force.y', forces(1), ierr)
      call wanted(ierr)
      call wrcnid(scene, 'wheelset.moment.z', forces(2), ierr)
      call wanted(ierr)
      end

      subroutine closed
      implicit none
      integer*8 scene, solver
      integer keys(5), forces(2)
      common /wrc/ scene, solver, keys, forces
      integer ierr
      call wrcdel(solver, ierr)
      call wrcdel(scene, ierr)
      end

c Stops with the library's text if a call has failed.
      subroutine wanted(ierr)
      implicit none
      integer ierr, i
      integer*8 scene, solver
      integer keys(5), forces(2)
      common /wrc/ scene, solver, keys, forces
      character*200 text
      if (ierr .eq. 0) return
      call wrcerr(scene, text, i)
      write (*, '(a, i3, 2a)') 'wrcontact', ierr, ': ', text
      stop 1
      end

c A result of the scene.
      real*8 function result(name)
      implicit none
      character*(*) name
      integer*8 scene, solver
      integer keys(5), forces(2)
      common /wrc/ scene, solver, keys, forces
      integer ierr
      call wrcnum(scene, name, result, ierr)
      call wanted(ierr)
      end

c Solves the contact of both wheels. State: y, psi, y', psi'; SI.
      subroutine posed(state)
      implicit none
      real*8 state(4), inputs(5)
      real*8 mass, inert, ky, kpsi, v
      common /veh/ mass, inert, ky, kpsi, v
      integer*8 scene, solver
      integer keys(5), forces(2)
      common /wrc/ scene, solver, keys, forces
      integer ierr
      inputs(1) = 1.0d3*state(1)
      inputs(2) = state(2)
      inputs(3) = 1.0d3*v
      inputs(4) = 1.0d3*state(3)
      inputs(5) = state(4)
      call wrcstb(scene, keys, inputs, 5, ierr)
      call wanted(ierr)
      call wrcstp(solver, scene, ierr)
      call wanted(ierr)
      end

c Accelerations of the wheelset.
      subroutine accel(state, rate)
      implicit none
      real*8 state(4), rate(4), found(2)
      real*8 mass, inert, ky, kpsi, v
      common /veh/ mass, inert, ky, kpsi, v
      integer*8 scene, solver
      integer keys(5), forces(2)
      common /wrc/ scene, solver, keys, forces
      integer ierr
      call posed(state)
      call wrcrdb(scene, forces, found, 2, ierr)
      call wanted(ierr)
      rate(1) = state(3)
      rate(2) = state(4)
      rate(3) = (found(1) - ky*state(1))/mass
      rate(4) = (1.0d-3*found(2) - kpsi*state(2))/inert
      end

c Runs nstep steps of h seconds from the displacement y0. Tells the
c amplitude and the wavelength between the first and the last zero of
c y, and the largest |y| of either half.
      subroutine run(y0, h, nstep, shown, ampl, wave, first, last)
      implicit none
      real*8 y0, ampl, wave, first, last
      integer nstep
      logical shown
      real*8 mass, inert, ky, kpsi, v
      common /veh/ mass, inert, ky, kpsi, v
      real*8 h, s(4), p(4), k1(4), k2(4), yold, zero(2)
      integer i, j, nzero
      s(1) = y0
      s(2) = 0.0d0
      s(3) = 0.0d0
      s(4) = 0.0d0
      first = 0.0d0
      last = 0.0d0
      nzero = 0
      zero(1) = 0.0d0
      ampl = 0.0d0
      wave = 0.0d0
      if (shown) write (*, '(a)') '      x, m     y, mm psi, mrad'
      do 30 i = 1, nstep
        yold = s(1)
        call accel(s, k1)
        do 10 j = 1, 4
          p(j) = s(j) + h*k1(j)
   10   continue
        call accel(p, k2)
        do 20 j = 1, 4
          s(j) = s(j) + 0.5d0*h*(k1(j) + k2(j))
   20   continue
        if (2*i .le. nstep) first = max(first, abs(s(1)))
        if (2*i .gt. nstep) last = max(last, abs(s(1)))
        if (yold*s(1) .lt. 0.0d0) then
          nzero = nzero + 1
          zero(2) = v*h*(i - 1 + yold/(yold - s(1)))
          if (nzero .eq. 1) zero(1) = zero(2)
          if (nzero .gt. 1) wave = 2.0d0*(zero(2) - zero(1))/(nzero - 1)
        end if
        if (nzero .gt. 0) ampl = max(ampl, abs(s(1)))
        if (shown .and. mod(i, nstep/10) .eq. 0) write (*, '(3f10.3)')
     &    v*h*i, 1.0d3*s(1), 1.0d3*s(2)
   30 continue
      end

c Equivalent conicity at an amplitude, by harmonic linearization of the
c rolling radius difference, and Klingel's wavelength:
c   conic = 1/(2 pi A) integral of dr(A sin u) sin u du, 0 to 2 pi
c   lambda = 2 pi sqrt(r s/(2 conic)), s the distance of the contacts
      subroutine klingl(ampl, conic, lambda)
      implicit none
      real*8 ampl, conic, lambda
      integer n, i
      parameter (n = 48)
      real*8 result, pi, u, dr, r, s, state(4)
      data state /4*0.0d0/
      save state
      pi = acos(-1.0d0)
      conic = 0.0d0
      r = 0.0d0
      s = 0.0d0
      do 10 i = 1, n
        u = 2.0d0*pi*(i - 0.5d0)/n
        state(1) = ampl*sin(u)
        call posed(state)
        dr = 1.0d-3*(result('left.centroid.rolling_radius')
     &    - result('right.centroid.rolling_radius'))
        conic = conic + dr*sin(u)/(n*ampl)
        r = r + 0.5d-3*(result('left.centroid.rolling_radius')
     &    + result('right.centroid.rolling_radius'))/n
        s = s + 1.0d-3*(result('left.centroid.y')
     &    - result('right.centroid.y'))/n
   10 continue
      lambda = 2.0d0*pi*sqrt(r*s/(2.0d0*conic))
      end
