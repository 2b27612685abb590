c The steps of vehicle_steps.f90 through the F77 layer.
c Usage: vehicle_steps_f77 [N]
      program vsteps
      implicit none
      integer*8 scene, solver, start, now, rate
      integer steps, i, j, ierr, early, reskb
      real*8 total, value, pi
      character*20 names(8), argmnt
      data names /'left.lateral_force', 'right.lateral_force',
     &  'left.pmax', 'right.pmax', 'left.centroid.y',
     &  'right.centroid.y', 'roll', 'vertical'/
      pi = acos(-1.0d0)
      steps = 3000
      call getarg(1, argmnt)
      if (argmnt .ne. ' ') read (argmnt, *) steps
      call wrcnew(scene, 'scene', kind(0), ierr)
      if (ierr .ne. 0) stop 1
      call wrcnew(solver, 'solver', kind(0), ierr)
      if (ierr .ne. 0) stop 1
      call wrcset(scene, 'solve.accuracy', 1.0d-2, ierr)
      total = 0.0d0
      early = 0
      call system_clock(start, rate)
      do 20 i = 1, steps
        call wrcset(scene, 'pose.lateral', 5.0d0*sin(2.0d0*pi*i
     &    /2000.0d0), ierr)
        call wrcset(scene, 'pose.yaw', 2.0d-3*cos(2.0d0*pi*i
     &    /2000.0d0), ierr)
        call wrcstp(solver, scene, ierr)
        if (ierr .ne. 0) stop 1
        do 10 j = 1, 8
          call wrcnum(scene, names(j), value, ierr)
          if (ierr .ne. 0) stop 1
          total = total + value
   10   continue
        if (i .eq. max(steps/10, 1000)) early = reskb()
   20 continue
      call system_clock(now)
      write (*, '(a, i0)') 'steps ', steps
      write (*, '(a, f0.3)') 'microseconds_per_step ',
     &  1.0d6*dble(now - start)/dble(rate)/steps
      write (*, '(a, es24.16)') 'sum ', total
      write (*, '(a, i0)') 'resident_kb ', reskb()
      write (*, '(a, i0)') 'growth_kb ', reskb() - early
      call wrcdel(solver, ierr)
      call wrcdel(scene, ierr)
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
