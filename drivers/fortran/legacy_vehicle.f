c A wheelset hunting along straight track: an old vehicle program that
c calls wrcontact every time step through the F77 layer.
c
c Model: two degrees of freedom, lateral displacement y (to the left)
c and yaw psi, of a wheelset that runs at constant speed v, held to a
c steady frame by a lateral and a yaw spring (free in the first run):
c
c   m y"    = sum(Q_y + F_y) - k_y y
c   Iz psi" = sum(M_z - y_c F_x) - k_psi psi
c
c Q_y: lateral components of the normal forces, which make up the
c gravitational stiffness; F_x, F_y, M_z: creep forces and moment of
c each patch at y_c. The library finds contact points (roll and height
c solved), normal forces, patches of both wheels at every evaluation.
c Not modelled: inertia in roll and bounce (80 kN stay on each wheel),
c velocity of roll in the creepages, drive and brake torques: the axle
c turns with 2 v/(r_left + r_right).
c
c Creep forces: Kalker's linear theory on the Hertzian ellipse of each
c patch, semi-axes a along and b across the rail, c = sqrt(a b):
c   F_x = -G c**2 C11 xi
c   F_y = -G c**2 (C22 eta + c C23 phi)
c   M_z =  G c**3 (C23 eta - c C33 phi)
c (coefficients of Kalker 1967 for Poisson's ratio 0.25, tabulated in
c Kalker 1990, appendix E), saturated on the friction limit (Shen,
c Hedrick & Elkins 1983, after Vermeulen & Johnson 1964) with
c t = sqrt(F_x**2 + F_y**2)/(mu N):
c   F  <- F mu N/|F| (t - t**2/3 + t**3/27) for t < 3, else mu N
c Creepages, x along the wheelset's heading, angle d of the contact:
c   xi  = (v - psi' y_c - omega r)/v
c   eta = (y'/v - psi)/cos(d)
c   phi = (psi' cos(d) - omega sin(d))/v
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

c Scene and solver of the wheelset, made once.
      subroutine opened
      implicit none
      integer*8 scene, solver
      common /wrc/ scene, solver
      integer ierr
      call wrcnew(scene, 'scene', kind(0), ierr)
      if (ierr .ne. 0) stop 'no scene'
      call wrcnew(solver, 'solver', kind(0), ierr)
      if (ierr .ne. 0) stop 'no solver'
      call wrcset(scene, 'solve.accuracy', 1.0d-2, ierr)
      call wanted(ierr)
      call wrcset(scene, 'load.vertical', 80.0d3, ierr)
      call wanted(ierr)
      end

      subroutine closed
      implicit none
      integer*8 scene, solver
      common /wrc/ scene, solver
      integer ierr
      call wrcdel(solver, ierr)
      call wrcdel(scene, ierr)
      end

c Stops with the library's text if a call has failed.
      subroutine wanted(ierr)
      implicit none
      integer ierr, i
      integer*8 scene, solver
      common /wrc/ scene, solver
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
      common /wrc/ scene, solver
      integer ierr
      call wrcnum(scene, name, result, ierr)
      call wanted(ierr)
      end

c Solves the contact of both wheels; y in m, psi in rad.
      subroutine posed(y, psi)
      implicit none
      real*8 y, psi
      integer*8 scene, solver
      common /wrc/ scene, solver
      integer ierr
      call wrcset(scene, 'pose.lateral', 1.0d3*y, ierr)
      call wanted(ierr)
      call wrcset(scene, 'pose.yaw', psi, ierr)
      call wanted(ierr)
      call wrcstp(solver, scene, ierr)
      call wanted(ierr)
      end

c Accelerations of the wheelset. State: y, psi, y', psi'; SI.
      subroutine accel(state, rate)
      implicit none
      real*8 state(4), rate(4)
      real*8 mass, inert, ky, kpsi, v
      common /veh/ mass, inert, ky, kpsi, v
      integer*8 scene, solver
      common /wrc/ scene, solver
      real*8 result, omega, fy, mz
      integer i, ierr, side
      character*5 wheel(2)
      character*24 patch
      real*8 force
      save wheel
      data wheel /'left', 'right'/
      call posed(state(1), state(2))
      omega = 2.0d3*v/(result('left.centroid.rolling_radius')
     &  + result('right.centroid.rolling_radius'))
      fy = result('left.lateral_force') + result('right.lateral_force')
     &  - ky*state(1)
      mz = -kpsi*state(2)
      do 20 side = 1, 2
        do 10 i = 0, 9
          write (patch, '(2a, i1, a)') trim(wheel(side)), '.patches.',
     &      i, '.'
          call wrcnum(scene, trim(patch)//'normal_force', force, ierr)
c         Status 2, unknown name: there is no such patch.
          if (ierr .eq. 2) goto 20
          call wanted(ierr)
          call creep(trim(patch), force, state, omega, v, fy, mz)
   10   continue
   20 continue
      rate(1) = state(3)
      rate(2) = state(4)
      rate(3) = fy/mass
      rate(4) = mz/inert
      end

c Adds the creep forces of a patch, in the track's frame.
      subroutine creep(patch, normal, state, omega, v, fy, mz)
      implicit none
      character*(*) patch
      real*8 normal, state(4), omega, v, fy, mz
      real*8 shear, mu
      parameter (shear = 80.77d9, mu = 0.3d0)
      real*8 result, a, b, c, y, r, angle, xi, eta, phi
      real*8 c11, c22, c23, c33, fxl, fyl, t, share
      a = 1.0d-3*result(patch//'semi_axes.0')
      b = 1.0d-3*result(patch//'semi_axes.1')
      y = 1.0d-3*result(patch//'centroid.y')
      r = 1.0d-3*result(patch//'centroid.rolling_radius')
      angle = result(patch//'centroid.angle')
      xi = (v - state(4)*y - omega*r)/v
      eta = (state(3)/v - state(2))/cos(angle)
      phi = (state(4)*cos(angle) - omega*sin(angle))/v
      call kalker(a/b, c11, c22, c23, c33)
      c = sqrt(a*b)
      fxl = -shear*c**2*c11*xi
      fyl = -shear*c**2*(c22*eta + c*c23*phi)
      t = sqrt(fxl**2 + fyl**2)/(mu*normal)
      share = 1.0d0
      if (t .gt. 0.0d0) share = 1.0d0/t
      if (t .lt. 3.0d0) share = 1.0d0 - t/3.0d0 + t**2/27.0d0
      fy = fy + share*(fyl*cos(angle) + fxl*state(2))
      mz = mz - share*fxl*y + share*shear*c**3*(c23*eta - c*c33*phi)
      end

c Kalker's creep coefficients for Poisson's ratio 0.25 over a/b.
      subroutine kalker(ratio, c11, c22, c23, c33)
      implicit none
      real*8 ratio, c11, c22, c23, c33
      integer n, i
      parameter (n = 19)
      real*8 x(n), t11(n), t22(n), t23(n), t33(n), at, w
      save x, t11, t22, t23, t33
c     a/b from 0.1 to 1 in tenths, then b/a from 0.9 to 0.1, as 2 - b/a,
c     which goes on in the same steps.
      data x /0.1d0, 0.2d0, 0.3d0, 0.4d0, 0.5d0, 0.6d0, 0.7d0, 0.8d0,
     &  0.9d0, 1.0d0, 1.1d0, 1.2d0, 1.3d0, 1.4d0, 1.5d0, 1.6d0, 1.7d0,
     &  1.8d0, 1.9d0/
      data t11 /3.31d0, 3.37d0, 3.44d0, 3.53d0, 3.62d0, 3.72d0, 3.81d0,
     &  3.91d0, 4.01d0, 4.12d0, 4.22d0, 4.36d0, 4.54d0, 4.78d0, 5.10d0,
     &  5.57d0, 6.34d0, 7.78d0, 11.7d0/
      data t22 /2.52d0, 2.63d0, 2.75d0, 2.88d0, 3.01d0, 3.14d0, 3.28d0,
     &  3.41d0, 3.54d0, 3.67d0, 3.81d0, 3.99d0, 4.21d0, 4.50d0, 4.90d0,
     &  5.48d0, 6.40d0, 8.14d0, 12.8d0/
      data t23 /0.473d0, 0.603d0, 0.715d0, 0.823d0, 0.929d0, 1.03d0,
     &  1.14d0, 1.25d0, 1.36d0, 1.47d0, 1.59d0, 1.75d0, 1.95d0, 2.23d0,
     &  2.62d0, 3.24d0, 4.32d0, 6.63d0, 14.6d0/
      data t33 /8.28d0, 4.27d0, 2.96d0, 2.32d0, 1.93d0, 1.68d0, 1.50d0,
     &  1.37d0, 1.27d0, 1.19d0, 1.11d0, 1.04d0, 0.965d0, 0.892d0,
     &  0.819d0, 0.747d0, 0.674d0, 0.601d0, 0.526d0/
      at = ratio
      if (ratio .gt. 1.0d0) at = 2.0d0 - 1.0d0/ratio
      at = min(max(at, x(1)), x(n))
      i = min(int(10.0d0*at), n - 1)
      w = 10.0d0*(at - x(i))
      c11 = t11(i) + w*(t11(i + 1) - t11(i))
      c22 = t22(i) + w*(t22(i + 1) - t22(i))
      c23 = t23(i) + w*(t23(i + 1) - t23(i))
      c33 = t33(i) + w*(t33(i + 1) - t33(i))
      end

c Runs nstep steps of h seconds from the displacement y0. Tells the
c amplitude and the wavelength between the first and the last zero of
c y, and the largest |y| of either half.
      subroutine run(y0, h, nstep, told, ampl, wave, first, last)
      implicit none
      real*8 y0, ampl, wave, first, last
      integer nstep
      logical told
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
      if (told) write (*, '(a)') '      x, m     y, mm psi, mrad'
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
        if (told .and. mod(i, nstep/10) .eq. 0) write (*, '(3f10.3)')
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
      real*8 result, pi, u, dr, r, s
      pi = acos(-1.0d0)
      conic = 0.0d0
      r = 0.0d0
      s = 0.0d0
      do 10 i = 1, n
        u = 2.0d0*pi*(i - 0.5d0)/n
        call posed(ampl*sin(u), 0.0d0)
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
