c The steps of vehicle_steps.f90 through the F77 layer.
c Usage: vehicle_steps_f77 [N]
      program vsteps
      implicit none
      integer*8 scene, solver, start, now, rate
      integer steps, i, j, ierr, early, reskb, inids(12), outids(60)
      real*8 total, pi, in(12), out(60), extime
      character*20 innam(12), sumnam(8), argmnt
      character*34 othnam(26)
      data innam /'pose.lateral', 'pose.yaw', 'load.left',
     &  'load.right', 'friction.left', 'friction.right',
     &  'motion.speed', 'motion.lateral', 'motion.yaw', 'motion.roll',
     &  'motion.vertical', 'motion.curvature'/
c     Those that are added up, and those of each wheel.
      data sumnam /'left.lateral_force', 'right.lateral_force',
     &  'left.pmax', 'right.pmax', 'left.centroid.y',
     &  'right.centroid.y', 'roll', 'vertical'/
      data othnam /'total.force.x', 'total.force.y', 'total.force.z',
     &  'total.moment.x', 'total.moment.y', 'total.moment.z',
     &  'patch_count', 'normal_force', 'vertical_force', 'depth',
     &  'angle', 'approach', 'centroid.x', 'centroid.z',
     &  'centroid.s_wheel', 'centroid.rolling_radius',
     &  'patches.0.normal_force', 'patches.0.angle', 'patches.0.x',
     &  'patches.0.y', 'patches.0.z', 'patches.0.pmax',
     &  'patches.0.approach', 'patches.0.semi_axes.longitudinal',
     &  'patches.0.semi_axes.lateral', 'patches.0.coupling_weight'/
      data in /0.0d0, 0.0d0, 8.0d4, 8.0d4, 0.3d0, 0.3d0, 2.0d4,
     &  5*0.0d0/
      pi = acos(-1.0d0)
      steps = 3000
      call getarg(1, argmnt)
      if (argmnt .ne. ' ') read (argmnt, *) steps
      call wrcopn(scene, 'scene', kind(0), 1.0d0, ierr)
      if (ierr .ne. 0) stop 1
      call wrcopn(solver, 'solver', kind(0), 1.0d0, ierr)
      if (ierr .ne. 0) stop 1
      call wrcset(scene, 'solve.accuracy', 1.0d-2, ierr)
      if (ierr .ne. 0) stop 1
      call wrcstx(scene, 'solve.creep', 'none', ierr)
      if (ierr .ne. 0) stop 1
      do 10 i = 1, 12
        call wrckid(scene, innam(i), inids(i), ierr)
        if (ierr .ne. 0) stop 1
   10 continue
      do 15 i = 1, 8
        call wrcnid(scene, sumnam(i), outids(i), ierr)
        if (ierr .ne. 0) stop 1
   15 continue
      do 20 i = 1, 26
        call wrcnid(scene, 'left.'//othnam(i), outids(i + 8), ierr)
        if (ierr .ne. 0) stop 1
        call wrcnid(scene, 'right.'//othnam(i), outids(i + 34), ierr)
        if (ierr .ne. 0) stop 1
   20 continue
      total = 0.0d0
      early = 0
      call system_clock(start, rate)
      do 40 i = 1, steps
        in(1) = 5.0d0*sin(2.0d0*pi*i/2000.0d0)
        in(2) = 2.0d-3*cos(2.0d0*pi*i/2000.0d0)
        call wrcstb(scene, inids, in, 12, ierr)
        if (ierr .ne. 0) stop 1
        call wrcstp(solver, scene, ierr)
        if (ierr .ne. 0) stop 1
        call wrcrdb(scene, outids, out, 60, ierr)
        if (ierr .ne. 0) stop 1
        do 30 j = 1, 8
          total = total + out(j)
   30   continue
        if (i .eq. max(steps/10, 1000)) early = reskb()
   40 continue
      call system_clock(now)
      write (*, '(a, i0)') 'steps ', steps
      write (*, '(a, f0.3)') 'microseconds_per_step ',
     &  1.0d6*dble(now - start)/dble(rate)/steps
      write (*, '(a, es24.16)') 'sum ', total
      write (*, '(a, i0)') 'resident_kb ', reskb()
      write (*, '(a, i0)') 'growth_kb ', reskb() - early
      write (*, '(a, i0)') 'nanoseconds_per_exchange ',
     &  nint(extime(scene, inids, in, outids, out))
      call wrcdel(solver, ierr)
      call wrcdel(scene, ierr)
      end

c Median time of setting the inputs and reading the results, in ns.
      real*8 function extime(scene, inids, in, outids, out)
      implicit none
      integer*8 scene, start, now, rate
      integer inids(12), outids(60), i, j, ierr
      real*8 in(12), out(60), times(1001), time
      do 30 i = 1, 1001
        call system_clock(start, rate)
        do 10 j = 1, 100
          call wrcstb(scene, inids, in, 12, ierr)
          if (ierr .ne. 0) stop 1
          call wrcrdb(scene, outids, out, 60, ierr)
          if (ierr .ne. 0) stop 1
   10   continue
        call system_clock(now)
        time = 1.0d7*dble(now - start)/dble(rate)
        do 20 j = i, 2, -1
          if (times(j - 1) .le. time) exit
          times(j) = times(j - 1)
   20   continue
        times(j) = time
   30 continue
      extime = times(501)
      end

      integer function reskb()
      implicit none
      character*80 line
      reskb = 0
      open (unit=20, file='/proc/self/status', status='old')
   10 read (20, '(a)', end=20) line
      if (line(1:6) .eq. 'VmRSS:') read (line(7:index(line, 'kB') - 1),
     &  *) reskb
      goto 10
   20 close (20)
      end
