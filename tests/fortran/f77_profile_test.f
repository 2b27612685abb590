c Profiles of the F77 layer; part of f77_test.f.

c A circle of 300 mm as a rail: its radius of curvature is found.
      subroutine tprof
      implicit none
      integer n
      parameter (n = 201)
      integer*8 rail, scene, wheel
      integer ierr, i
      real*8 y(n), z(n), value, known
      character*40 text
      ierr = -1
      call wrcnew(rail, 'profile', kind(0), ierr)
      call expect(ierr .eq. 0, 'a profile')
      do 10 i = 1, n
        y(i) = 0.3d0*(i - 101)
        z(i) = sqrt(300.0d0**2 - y(i)**2) - 300.0d0
   10 continue
      call wrcnew(scene, 'scene', kind(0), ierr)
      ierr = -1
      call wrcput(scene, 'track.rail', rail, ierr)
      call expect(ierr .eq. 10, 'an empty profile')
      ierr = -1
      call wrcpts(rail, 'a circle', 1, y, z, n, ierr)
      call expect(ierr .eq. 0, 'points')
      call wrctxt(rail, 'name', text, ierr)
      call expect(ierr .eq. 0 .and. text .ne. ' ', 'with a name')
      ierr = -1
      call wrcput(scene, 'track.rail', rail, ierr)
      call expect(ierr .eq. 0, 'a rail of its own')
      ierr = -1
      call wrcput(scene, 'wheelset.wheel', rail, ierr)
      call expect(ierr .eq. 1, 'but no wheel')
      ierr = -1
      call wrcpts(rail, 'a circle', 7, y, z, n, ierr)
      call expect(ierr .eq. 1, 'kinds are 0 and 1')
      ierr = -1
      call wrcstd(rail, '60E1', ierr)
      call expect(ierr .eq. 0, 'a standard rail')
      call wrcput(scene, 'track.rail', rail, ierr)
      call wrcsol(scene, ierr)
      call wrcnum(scene, 'left.pmax', value, ierr)
      call wrcstx(scene, 'track.rail', '60E1', ierr)
      call wrcsol(scene, ierr)
      call wrcnum(scene, 'left.pmax', known, ierr)
      call expect(abs(value - known) .le. 0.0d0, 'as by its name')
      call wrcnew(wheel, 'profile', kind(0), ierr)
      ierr = -1
      call wrcfil(wheel, 'not_there.prw', ierr)
      call expect(ierr .eq. 3, 'no file')
      call wrcdel(wheel, ierr)
      call wrcdel(rail, ierr)
      call wrcdel(scene, ierr)
      end

c Points of a rail in m, upside down and with the sides exchanged are
c read as those in mm if they are said to be so, and else not.
c Pressures are those of a scene, to its accuracy of 1e-3.
      subroutine tread
      implicit none
      integer n
      parameter (n = 201)
      integer*8 rail
      integer ierr, i
      real*8 y(n), z(n), ym(n), zm(n), known, railpm
      call wrcopn(rail, 'profile', kind(0), 1.0d0, ierr)
      open (unit=21, file='f77_test_rail.txt')
      do 10 i = 1, n
        y(i) = 0.34d0*(i - 101)
        z(i) = sqrt(300.0d0**2 - (y(i) - 4.0d0)**2) - 300.0d0
     &    - 0.15d0*max(0.0d0, abs(y(i)) - 24.0d0)**2.2d0
        ym(i) = -1.0d-3*y(i)
        zm(i) = -1.0d-3*z(i)
        write (21, '(2es25.16)') ym(i), zm(i)
   10 continue
      close (21)
      call wrcpts(rail, 'in mm', 1, y, z, n, ierr)
      known = railpm(rail)
      ierr = -1
      call wrcptx(rail, 'in m', 1, ym, zm, n, 1, 1, 1, 1.0d3, 0.0d0,
     &  ierr)
      call expect(ierr .eq. 0, 'points in m')
      call expect(abs(railpm(rail) - known) .lt. 1.0d-3*known,
     &  'the same rail')
      ierr = -1
      call wrcptx(rail, 'in m', 1, ym, zm, n, -1, 1, 1, 1.0d3, 0.0d0,
     &  ierr)
      call expect(ierr .eq. 0, 'not mirrored')
      call expect(abs(railpm(rail) - known) .gt. 1.0d-2*known,
     &  'another rail')
      ierr = -1
      call wrcptx(rail, 'smoothed', 1, y, z, n, 0, 0, 0, 1.0d0, 30.0d0,
     &  ierr)
      call expect(ierr .eq. 0, 'smoothed')
      call expect(abs(railpm(rail) - known) .gt. 1.0d-2*known,
     &  'changes the rail')
      ierr = -1
      call wrcptx(rail, 'no kind', -1, y, z, n, 0, 0, 0, 0.0d0, 0.0d0,
     &  ierr)
      call expect(ierr .eq. 1, 'points have a kind')
      ierr = -1
      call wrcptx(rail, 'mirror 2', 1, y, z, n, 0, 2, 0, 0.0d0, 0.0d0,
     &  ierr)
      call expect(ierr .eq. 1, 'mirroring is -1, 0 or 1')

      ierr = -1
      call wrcflx(rail, 'f77_test_rail.txt', 1, 1, 1, 1, 1.0d3, 0.0d0,
     &  ierr)
      call expect(ierr .eq. 0, 'a file in m')
      call expect(abs(railpm(rail) - known) .lt. 1.0d-3*known,
     &  'the rail of the file')
      ierr = -1
      call wrcflx(rail, 'f77_test_rail.txt', 1, 1, 1, 0, 0.0d0, 0.0d0,
     &  ierr)
      call expect(ierr .eq. 0, 'its scale is guessed')
      ierr = -1
      call wrcflx(rail, 'f77_test_rail.txt', 1, 1, 1, 1, 0.0d0, 0.0d0,
     &  ierr)
      call expect(ierr .eq. 4, 'but not by strict reading')
      ierr = -1
      call wrcflx(rail, 'f77_test_rail.txt', -1, 1, 1, 0, 1.0d3, 0.0d0,
     &  ierr)
      call expect(ierr .eq. 0, 'and its kind by the shape')
      ierr = -1
      call wrcflx(rail, 'f77_test_rail.txt', -1, 1, 1, 1, 1.0d3, 0.0d0,
     &  ierr)
      call expect(ierr .eq. 4, 'but not that either')
      ierr = -1
      call wrcflx(rail, 'f77_test_rail.txt', 1, 1, 1, 0, 1.0d3, 1.0d3,
     &  ierr)
      call expect(ierr .eq. 1, 'no such wavelength')
      call wrcdel(rail, ierr)
      end

c The largest pressure on a rail.
      real*8 function railpm(rail)
      implicit none
      integer*8 rail, scene
      integer ierr
      call wrcopn(scene, 'scene', kind(0), 1.0d0, ierr)
      call wrcput(scene, 'track.rail', rail, ierr)
      call wrcstx(scene, 'solve.side', 'left', ierr)
      ierr = -1
      call wrcsol(scene, ierr)
      call expect(ierr .eq. 0, 'solved on this rail')
      railpm = -1.0d0
      call wrcnum(scene, 'left.pmax', railpm, ierr)
      call wrcdel(scene, ierr)
      end
