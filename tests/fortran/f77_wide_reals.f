c An old program whose reals have 16 bytes, and which looks at IERR at
c the end only: it gets a text, and no numbers.
      program f77wid
      implicit none
      integer*8 scene
      integer ierr
      real*8 pmax
      character*120 text
      pmax = -1.0d0
      call wrcopn(scene, 'scene', kind(0), 1.0d0, ierr)
      call wrcset(scene, 'pose.lateral', 3.0d0, ierr)
      call wrcsol(scene, ierr)
      call wrcnum(scene, 'left.pmax', pmax, ierr)
      if (ierr .eq. 0) stop 'a result'
      if (pmax .gt. 0.0d0) stop 'a number'
      call wrcerr(scene, text, ierr)
      write (*, '(a)') text
      end
