c The F77 layer as an old program calls it. Built four times: program
c and layer each with integers of 4 and of 8 bytes. Counts and IERR are
c filled with ones before each call, so that half a write is seen.
      program f77tst
      implicit none
      integer nbad
      common /bad/ nbad
      character*8 extent
      nbad = 0
      call get_environment_variable('WRCONTACT_TEST_EXTENT', extent)
      call tscene
      call tids
      call tstep
      call tvehic
      call tstill
      if (extent .eq. 'long') call tctabl
      call tnorm
      call troll
      call tprof
      call tread
      call trefus
      call tgarbg
      if (nbad .ne. 0) then
        write (*, *) nbad, ' expectations failed'
        stop 1
      end if
      end

c Counts what is not so.
      subroutine expect(cond, what)
      implicit none
      logical cond
      character*(*) what
      integer nbad
      common /bad/ nbad
      if (cond) return
      nbad = nbad + 1
      write (*, *) 'not so: ', what
      end

      subroutine tscene
      implicit none
      integer*8 scene
      integer ierr, n, nlat, nlon, i
      real*8 pmax, value, load, p(60000), grid(2), da, db
      character*40 text
      character*3 short
      save p
      ierr = -1
      call wrcnew(scene, 'scene', kind(0), ierr)
      call expect(ierr .eq. 0, 'a scene')
      ierr = -1
      call wrcnum(scene, 'left.pmax', value, ierr)
      call expect(ierr .eq. 10, 'no result yet')
      ierr = -1
      call wrcerr(scene, text, ierr)
      call expect(ierr .eq. 0 .and. text .ne. ' ', 'and a text')
      ierr = -1
      call wrcset(scene, 'pose.lateral', 3.0d0, ierr)
      call expect(ierr .eq. 0, 'a number is set')
      ierr = -1
      call wrcget(scene, 'pose.lateral', value, ierr)
      call expect(ierr .eq. 0 .and. abs(value - 3.0d0) .le. 0.0d0,
     &  'and told')
      ierr = -1
      call wrcstx(scene, 'solve.side   ', 'left  ', ierr)
      call expect(ierr .eq. 0, 'a text is set')
      ierr = -1
      call wrcgtx(scene, 'solve.side', text, ierr)
      call expect(ierr .eq. 0 .and. text .eq. 'left', 'and told')
      ierr = -1
      call wrcsol(scene, ierr)
      call expect(ierr .eq. 0, 'solved')
      ierr = -1
      call wrcnum(scene, 'left.pmax', pmax, ierr)
c     The paper's Table 1 at y = 3, to the accuracy of 1e-3.
      call expect(ierr .eq. 0 .and. abs(pmax - 1453.7d0) .lt. 1.4537d0,
     &  'the pressure')
      ierr = -1
      call wrctxt(scene, 'units', text, ierr)
      call expect(ierr .eq. 0 .and. text .eq. 'mm, N, MPa, rad',
     &  'a text result')
      ierr = -1
      call wrctxt(scene, 'units', short, ierr)
      call expect(ierr .eq. 9 .and. short .eq. 'mm,', 'cut to fit')
      n = -1
      ierr = -1
      call wrcfld(scene, 'left.pressure', p, 0, n, ierr)
      call expect(ierr .eq. 0 .and. n .gt. 100, 'a length')
      i = n
      n = -1
      ierr = -1
      call wrcfld(scene, 'left.pressure', p, 10, n, ierr)
      call expect(ierr .eq. 9 .and. n .eq. i, 'too small')
      n = -1
      ierr = -1
      call wrcfld(scene, 'left.pressure', p, 60000, n, ierr)
      call expect(ierr .eq. 0 .and. n .eq. i, 'a field')
      call wrcnum(scene, 'left.element_size.lateral', da, ierr)
      call wrcnum(scene, 'left.element_size.longitudinal', db, ierr)
      call wrcnum(scene, 'left.normal_force', value, ierr)
      load = 0.0d0
      do 10 i = 1, n
        load = load + p(i)*da*db
   10 continue
      call expect(abs(load - value) .lt. 1.0d-4*value, 'adds up')
      grid(1) = 32.0d0
      grid(2) = 16.0d0
      ierr = -1
      call wrcstn(scene, 'solve.grid', grid, 2, ierr)
      call expect(ierr .eq. 0, 'numbers are set')
      call wrcsol(scene, ierr)
      call wrcnum(scene, 'left.grid.lateral', value, ierr)
      nlat = nint(value)
      call wrcnum(scene, 'left.grid.longitudinal', value, ierr)
      nlon = nint(value)
      call expect(nlat .eq. 32 .and. nlon .eq. 16, 'and count')
      ierr = -1
      call wrcwrt(scene, 'f77_test_scene.toml', ierr)
      call expect(ierr .eq. 0, 'written')
      ierr = -1
      call wrcset(scene, 'pose.sideways', 1.0d0, ierr)
      call expect(ierr .eq. 2, 'unknown key')
      ierr = -1
      call wrcerr(scene, text, ierr)
      call expect(index(text, 'pose.sideways') .gt. 0, 'named')
      ierr = -1
      call wrcerr(scene, short, ierr)
      call expect(ierr .eq. 9, 'a text cut')
      call wrcver(text)
      call expect(index(text, '.') .gt. 1, 'a version')
      ierr = -1
      call wrcdel(scene, ierr)
      call expect(ierr .eq. 0 .and. scene .eq. 0, 'given back')
      end

c By id the same as by name.
      subroutine tids
      implicit none
      integer*8 scene
      integer ierr, keys(2), names(3), i
      real*8 in(2), out(3), value
      character*100 text
      call wrcnew(scene, 'scene', kind(0), ierr)
      do 10 i = 1, 3
        names(i) = -1
        keys(min(i, 2)) = -1
        out(i) = 7.0d0
   10 continue
      ierr = -1
      call wrckid(scene, 'pose.lateral', keys(1), ierr)
      call expect(ierr .eq. 0 .and. keys(1) .ge. 0, 'id of a key')
      ierr = -1
      call wrckid(scene, 'load.both', keys(2), ierr)
      call expect(ierr .eq. 0 .and. keys(2) .ne. keys(1), 'another')
      ierr = -1
      call wrcnid(scene, 'left.vertical_force', names(1), ierr)
      call expect(ierr .eq. 0 .and. names(1) .gt. 0, 'of a result')
      call wrcnid(scene, 'left.patches.5.pmax', names(2), ierr)
      call wrcnid(scene, 'roll', names(3), ierr)
      ierr = -1
      call wrcrdb(scene, names, out, 3, ierr)
      call expect(ierr .eq. 10 .and. nint(out(1)) .eq. 7, 'not yet')
      in(1) = 3.0d0
      in(2) = 6.0d4
      ierr = -1
      call wrcstb(scene, keys, in, 2, ierr)
      call expect(ierr .eq. 0, 'set by id')
      call wrcget(scene, 'load.right', value, ierr)
      call expect(abs(value - 6.0d4) .le. 0.0d0, 'and told by key')
      call wrcsol(scene, ierr)
      ierr = -1
      call wrcrdb(scene, names, out, 3, ierr)
      call expect(ierr .eq. 0, 'read by id')
      call wrcnum(scene, 'left.vertical_force', value, ierr)
      call expect(abs(out(1) - value) .le. 0.0d0, 'as by name')
      call expect(.not. abs(out(2)) .ge. 0.0d0, 'no such patch')
      call wrcnum(scene, 'roll', value, ierr)
      call expect(abs(out(3) - value) .le. 0.0d0, 'the last one')
      in(1) = 4.0d0
      in(2) = -1.0d0
      ierr = -1
      call wrcstb(scene, keys, in, 2, ierr)
      call expect(ierr .eq. 1, 'refused')
      call wrcerr(scene, text, ierr)
      call expect(index(text, 'load.both = -1') .gt. 0, 'named')
      call wrcget(scene, 'pose.lateral', value, ierr)
      call expect(abs(value - 3.0d0) .le. 0.0d0, 'none is set')
      ierr = -1
      call wrcrdb(scene, keys, out, 2, ierr)
      call expect(ierr .eq. 1, 'keys are no results')
      ierr = -1
      call wrcrdb(scene, names, out, -1, ierr)
      call expect(ierr .eq. 1, 'no such number of them')
      i = keys(1)
      ierr = -1
      call wrckid(scene, 'pose.sideways', keys(1), ierr)
      call expect(ierr .eq. 2 .and. keys(1) .eq. i, 'no such key')
      ierr = -1
      call wrcnid(scene, 'left.colour', keys(1), ierr)
      call expect(ierr .eq. 2 .and. keys(1) .eq. i, 'no such name')
      call wrcdel(scene, ierr)
      ierr = -1
      call wrcrdb(scene, names, out, 3, ierr)
      call expect(ierr .ne. 0, 'no scene')
      end

c A solver's steps end where a scene by itself does.
      subroutine tstep
      implicit none
      integer*8 solver, scene
      integer ierr, i
      real*8 step, alone
      ierr = -1
      call wrcnew(solver, 'SOLVER', kind(0), ierr)
      call expect(ierr .eq. 0, 'a solver')
      call wrcnew(scene, 'scene', kind(0), ierr)
      do 10 i = 0, 4
        call wrcset(scene, 'pose.lateral', 0.2d0*i, ierr)
        ierr = -1
        call wrcstp(solver, scene, ierr)
        call expect(ierr .eq. 0, 'a step')
   10 continue
      call wrcnum(scene, 'left.pmax', step, ierr)
      call wrcsol(scene, ierr)
      call wrcnum(scene, 'left.pmax', alone, ierr)
      call expect(abs(step - alone) .le. 0.0d0, 'bit for bit')
      call wrcclr(solver, ierr)
      call expect(ierr .eq. 0, 'all forgotten')
      call wrcstx(solver, 'precision', 'double', ierr)
      call expect(ierr .eq. 0, 'an option')
      call wrcstx(solver, 'precision', 'single', ierr)
      call expect(ierr .ne. 0, 'no such precision')
      ierr = -1
      call wrcset(scene, 'pose.lateral', 90.0d0, ierr)
      call wrcstp(solver, scene, ierr)
      call expect(ierr .eq. 5, 'no contact')
      call wrcdel(scene, ierr)
      call wrcdel(solver, ierr)
      end

c A sphere on a plane: Hertz.
      subroutine tnorm
      implicit none
      integer n
      parameter (n = 64)
      integer*8 normal
      integer ierr, m, i, j
      real*8 h(n*n), p(n*n), a, r, e, load, step, pi, value
      character*20 text
      pi = acos(-1.0d0)
      a = 5.0d0
      r = 500.0d0
      e = 1.1d5
      load = 4.0d0*e*a**3/(3.0d0*r)
      step = 2.0d0*a/45.0d0
      do 20 j = 1, n
        do 10 i = 1, n
          h(i + n*(j - 1)) = step**2*((i - 32.5d0)**2
     &      + (j - 32.5d0)**2)/(2.0d0*r)
   10   continue
   20 continue
      ierr = -1
      call wrcnew(normal, 'normal', kind(0), ierr)
      call expect(ierr .eq. 0, 'a normal contact')
      ierr = -1
      call wrcgrd(normal, n, n, step, step, ierr)
      call expect(ierr .eq. 0, 'a grid')
      ierr = -1
      call wrcgap(normal, h, n*n, ierr)
      call expect(ierr .eq. 0, 'a gap')
      call wrcset(normal, 'combined_modulus', e, ierr)
      call wrcset(normal, 'normal_load', load, ierr)
      call wrcstx(normal, 'precision', 'double', ierr)
      call expect(ierr .eq. 0, 'a text of a normal contact')
      ierr = -1
      call wrcsol(normal, ierr)
      call expect(ierr .eq. 0, 'solved')
      call wrcnum(normal, 'pmax', value, ierr)
c     0.15/45**2 by the grid, twice that to be safe.
      call expect(abs(value/(1.5d0*load/(pi*a**2)) - 1.0d0) .lt.
     &  1.5d-4, 'pmax of Hertz')
      call wrctxt(normal, 'stop_reason', text, ierr)
      call expect(text .eq. 'tolerance_met', 'converged')
      m = -1
      ierr = -1
      call wrcfld(normal, 'pressure', p, n*n, m, ierr)
      call expect(ierr .eq. 0 .and. m .eq. n*n, 'pressures')
      ierr = -1
      call wrcgap(normal, h, 7, ierr)
      call wrcsol(normal, ierr)
      call expect(ierr .eq. 1, 'a gap for each element')
      call wrcdel(normal, ierr)
      end

c Steps of rolling from tractions of none: the force grows.
      subroutine troll
      implicit none
      integer nx, ny, n
      parameter (nx = 8, ny = 4, n = nx*ny)
      integer*8 rollng
      integer ierr, m, i
      real*8 p(n), qx(n), qy(n), one, two, value
      character*60 text
      do 10 i = 1, n
        p(i) = 1000.0d0
   10 continue
      ierr = -1
      call wrcnew(rollng, 'rolling', kind(0), ierr)
      call expect(ierr .eq. 0, 'a rolling contact')
      ierr = -1
      call wrcgrd(rollng, ny, nx, 0.5d0, 0.5d0, ierr)
      call expect(ierr .eq. 0, 'its grid')
      ierr = -1
      call wrcadv(rollng, ierr)
      call expect(ierr .eq. 10, 'no step yet')
      ierr = -1
      call wrcprs(rollng, p, n, ierr)
      call expect(ierr .eq. 0, 'pressures')
      ierr = -1
      call wrcset(rollng, 'longitudinal_creepage', -0.002d0, ierr)
      call expect(ierr .eq. 0, 'a creepage')
      ierr = -1
      call wrcstx(rollng, 'contact', 'transient', ierr)
      call expect(ierr .eq. 0, 'a step')
      ierr = -1
      call wrcsol(rollng, ierr)
      call expect(ierr .eq. 0, 'a first step')
      ierr = -1
      call wrcnum(rollng, 'creep_force.longitudinal', one, ierr)
      call expect(ierr .eq. 0 .and. one .gt. 0.0d0, 'its force')
      ierr = -1
      m = -1
      call wrcfld(rollng, 'traction_x', qx, n, m, ierr)
      call expect(ierr .eq. 0 .and. m .eq. n, 'its tractions')
      call wrcfld(rollng, 'traction_y', qy, n, m, ierr)
      ierr = -1
      call wrcadv(rollng, ierr)
      call expect(ierr .eq. 0, 'to the next step')
      call wrcsol(rollng, ierr)
      call wrcnum(rollng, 'creep_force.longitudinal', two, ierr)
      call expect(two .gt. one, 'grows')
      ierr = -1
      call wrcprv(rollng, qx, qy, 0, ierr)
      call expect(ierr .eq. 0, 'no history')
      call wrcsol(rollng, ierr)
      call wrcnum(rollng, 'creep_force.longitudinal', value, ierr)
      call expect(abs(value - one) .le. 0.0d0, 'the first step')
      ierr = -1
      call wrcprv(rollng, qx, qy, n, ierr)
      call expect(ierr .eq. 0, 'a history')
      call wrcsol(rollng, ierr)
      call wrcnum(rollng, 'creep_force.longitudinal', value, ierr)
      call expect(abs(value - two) .le. 0.0d0, 'the second step')
      ierr = -1
      call wrctxt(rollng, 'stop_reason', text, ierr)
      call expect(ierr .eq. 1 .and. text .eq. ' ', 'no texts')
      ierr = -1
      call wrcgap(rollng, p, n, ierr)
      call expect(ierr .eq. 1, 'no gap')
      ierr = -1
      call wrcprs(rollng, p, 7, ierr)
      call wrcsol(rollng, ierr)
      call expect(ierr .eq. 1, 'a pressure for each element')
      call wrcerr(rollng, text, ierr)
      call expect(index(text, 'pressure') .gt. 0, 'and says so')
      ierr = -1
      call wrcdel(rollng, ierr)
      call expect(ierr .eq. 0 .and. rollng .eq. 0, 'given back')
      end

c Wrong handles and wrong widths: never a crash, always IERR.
      subroutine trefus
      implicit none
      integer*8 scene, solver, handle
      integer ierr, n
      real*8 value(1)
      character*60 text
      character*120 long
      ierr = -1
      handle = 4711
      call wrcnew(handle, 'scene', 5, ierr)
      call expect(ierr .ne. 0 .and. handle .eq. 0, 'no such width')
      ierr = -1
      call wrcnew(handle, 'wheel', kind(0), ierr)
      call expect(ierr .eq. 2 .and. handle .eq. 0, 'nothing such')
      ierr = 0
      call wrcset(handle, 'pose.lateral', 1.0d0, ierr)
      call expect(ierr .ne. 0, 'handle 0')
      ierr = 0
      call wrcerr(handle, text, ierr)
      call expect(ierr .ne. 0 .and. index(text, 'WRCNEW') .gt. 0,
     &  'its text')
      ierr = -1
      handle = 4711
      call wrcopn(handle, 'scene', 5, 1.0d0, ierr)
      call expect(ierr .ne. 0 .and. handle .eq. 0, 'no width at all')
      ierr = -1
      call wrcopn(handle, 'wheel', kind(0), 1.0d0, ierr)
      call expect(ierr .eq. 2 .and. handle .eq. 0, 'no such thing')
      ierr = -1
      call wrcopn(handle, 'scene', kind(0), 0.0d0, ierr)
      call expect(ierr .eq. 1, 'reals of another width')
      ierr = -1
      call wrcset(handle, 'pose.lateral', 1.0d0, ierr)
      call expect(ierr .eq. 1, 'are refused from then on')
      ierr = -1
      call wrcerr(handle, long, ierr)
      call expect(ierr .eq. 1 .and. index(long, '-fdefault-double-8')
     &  .gt. 0, 'and the cure is named')
      ierr = -1
      call wrcdel(handle, ierr)
      call expect(ierr .eq. 1 .and. handle .eq. 0, 'nothing is left')
      ierr = -1
      call wrcopn(scene, 'scene', kind(0), 1.0d0, ierr)
      call expect(ierr .eq. 0, 'opened')
      ierr = -1
      call wrcopn(solver, 'SOLVER', kind(0), 1.0d0, ierr)
      call expect(ierr .eq. 0, 'and a solver')
      ierr = -1
      call wrcstp(scene, solver, ierr)
      call expect(ierr .eq. 1, 'the wrong way round')
      ierr = -1
      call wrcset(solver, 'pose.lateral', 1.0d0, ierr)
      call expect(ierr .eq. 1, 'a solver has no keys')
      ierr = -1
      call wrcgrd(scene, 4, 4, 1.0d0, 1.0d0, ierr)
      call expect(ierr .eq. 1, 'a scene has no grid')
      ierr = -1
      n = -1
      call wrcfld(solver, 'left.pressure', value, 1, n, ierr)
      call expect(ierr .eq. 1, 'a solver has no fields')
      ierr = -1
      call wrcfld(scene, 'left.pressure', value, -1, n, ierr)
      call expect(ierr .ne. 0, 'no length')
      ierr = -1
      call wrcerr(solver, text, ierr)
      call expect(ierr .eq. 0 .and. index(text, 'is a solver') .gt. 0,
     &  'the text says what it is')
      call wrcclr(solver, ierr)
      call wrcerr(solver, text, ierr)
      call expect(ierr .eq. 0 .and. text .eq. ' ',
     &  'until it is used as it should')
      ierr = -1
      call wrcstp(solver, solver, ierr)
      call expect(ierr .eq. 1, 'a solver is no scene')
      call wrcerr(solver, text, ierr)
      call expect(index(text, 'scene') .gt. 0, 'said by the library')
      handle = scene
      call wrcdel(scene, ierr)
      ierr = -1
      call wrcset(handle, 'pose.lateral', 1.0d0, ierr)
      call expect(ierr .eq. 1, 'given back before')
      ierr = 0
      call wrcset(handle - mod(handle, 32_8), 'pose.lateral', 1.0d0,
     &  ierr)
      call expect(ierr .ne. 0, 'a handle without its mark')
      ierr = -1
      call wrcdel(handle, ierr)
      call expect(ierr .eq. 0, 'given back twice does nothing')
      call wrcdel(solver, ierr)
      end

c Numbers that no call has made say nothing about the width of IERR:
c what lies behind its first four bytes stays.
      subroutine tgarbg
      implicit none
      integer*8 handle
      integer*4 both(2)
      integer ierr, bit
      real*8 value
      equivalence (ierr, both(1))
      do 10 bit = 6, 62
        both(1) = 0
        both(2) = 4711
c       Low bits as of a scene of a program with integers of 8 bytes.
        handle = ibset(34_8, bit)
        call wrcnum(handle, 'left.pmax', value, ierr)
        call expect(both(1) .eq. 1 .and. both(2) .eq. 4711,
     &    'four bytes are written')
   10 continue
      do 20 bit = 1, 100
        handle = bit
        both(2) = 4711
        call wrcsol(handle, ierr)
        call expect(both(1) .eq. 1 .and. both(2) .eq. 4711,
     &    'also of small numbers')
   20 continue
      end
