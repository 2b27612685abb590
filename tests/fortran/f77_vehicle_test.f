c Calls for vehicle simulations of the F77 layer; part of f77_test.f.
      subroutine tvehic
      implicit none
      integer*8 scene, solver
      integer ierr, istate(2), n, i
      real*8 q(6), v(6), f(6,2), rails(3,2), dfdq(6,6,2), dfdv(6,6,2)
      real*8 patch(22,4), creep(3), force(3), deriv(3,3), value
      real*8 axes(5), table(2,6), height
      character*120 text
      data q /0.0d0, 3.0d0, 459.815d0, 1.8d-4, 0.0d0, 1.0d-3/
      data v /2.0d4, 15.0d0, 1.0d0, 2.0d-3, 43.5d0, -5.0d-3/
      data axes /-2.0d0, 0.0d0, 3.0d0, 0.0d0, 2.0d-3/
      data rails /6*0.0d0/
      save
      call wrcopn(scene, 'scene', kind(0), 1.0d0, ierr)
      call wrcopn(solver, 'solver', kind(0), 1.0d0, ierr)
      call wrcset(scene, 'solve.accuracy', 1.0d-2, ierr)
      call wrcstx(scene, 'solve.accuracy_of', 'forces', ierr)
      call wrcstx(scene, 'solve.creep', 'fastsim', ierr)
      istate(1) = -1
      istate(2) = -1
      n = -1
      ierr = -1
      dfdq(3,3,1) = 7.0d0
      call wrcveh(solver, scene, q, v, 0, rails, f, 0, dfdq, dfdv,
     &  istate, ierr)
      call expect(ierr .eq. 0, 'a step')
      call expect(istate(1) .eq. 0 .and. istate(2) .eq. 0, 'states')
      call expect(abs(dfdq(3,3,1) - 7.0d0) .le. 0.0d0, 'no derivatives')
      call wrcnum(scene, 'right.total.moment.y', value, ierr)
      call expect(abs(f(5,2) - value) .le. 0.0d0,
     &  'moment on the right wheel')
      call expect(f(3,1) .gt. 1.0d4 .and. f(3,2) .gt. 1.0d4, 'loads')
c     What a step has to do with its derivatives.
      call wrcveh(solver, scene, q, v, 0, rails, f, 1, dfdq, dfdv,
     &  istate, ierr)
      call expect(ierr .eq. 0 .and. dfdq(3,3,1) .lt. -1.0d5, 'stiff')
      height = f(3,1) + 0.001d0*dfdq(3,3,1)
      q(3) = q(3) + 0.001d0
      call wrcveh(solver, scene, q, v, 0, rails, f, 0, dfdq, dfdv,
     &  istate, ierr)
      call expect(abs(f(3,1) - height) .lt. 1.0d-2*height, 'as told')
c     The left rail up by as much as the wheel.
      value = f(3,1)
      rails(2,1) = 0.001d0
      call wrcveh(solver, scene, q, v, 1, rails, f, 0, dfdq, dfdv,
     &  istate, ierr)
      call expect(f(3,1) .gt. value + 5.0d2, 'the rail presses')
      call wrcpat(scene, patch, 0, n, ierr)
      call expect(ierr .eq. 0 .and. n .eq. 2, 'two patches')
      call wrcpat(scene, patch, 1, n, ierr)
      call expect(ierr .eq. 9 .and. n .eq. 2, 'no room for both')
      call wrcpat(scene, patch, 4, n, ierr)
      call expect(ierr .eq. 0 .and. abs(patch(1,2) - 1.0d0) .le. 0.0d0,
     &  'right')
      call wrcnum(scene, 'right.patches.0.friction_power', value, ierr)
      call expect(abs(patch(22,2) - value) .le. 0.0d0,
     &  'the last member')
      creep(1) = patch(15,2)
      creep(2) = patch(16,2)
      creep(3) = patch(17,2)
      call wrccrp(solver, scene, 2, creep, force, 1, deriv, ierr)
      call expect(ierr .eq. 0, 'creep forces')
      call expect(abs(force(2) - patch(13,2)) .lt. 1.0d-6*abs(force(2)),
     &  'those of the step')
      call expect(deriv(1,1) .lt. 0.0d0, 'creep damps')
      value = patch(11,2)
      call wrcfld(scene, 'right.lobe_normal_force', patch, 88, n, ierr)
      call expect(ierr .eq. 0 .and. n .eq. 1 .and. abs(patch(1,1)
     &  - value) .lt. 1.0d-9*value, 'one lobe with all the force')
      call wrccrp(solver, scene, 0, creep, force, 0, deriv, ierr)
      call expect(ierr .eq. 1, 'patches count from 1')
      q(3) = 470.0d0
      call wrcveh(solver, scene, q, v, 0, rails, f, 0, dfdq, dfdv,
     &  istate, ierr)
      call expect(ierr .eq. 0 .and. istate(2) .eq. 1, 'lifted')
      call expect(abs(f(3,2) - 0.0d0) .le. 0.0d0, 'no force')
      q(6) = 1.0d0
      ierr = -1
      call wrcveh(solver, scene, q, v, 0, rails, f, 0, dfdq, dfdv,
     &  istate, ierr)
      call wrcerr(scene, text, i)
      call expect(ierr .eq. 1 .and. index(text, 'pose.yaw = 1:') .eq. 1,
     &  'refused with its name')
      call wrcveh(scene, solver, q, v, 0, rails, f, 0, dfdq, dfdv,
     &  istate, ierr)
      call expect(ierr .eq. 1, 'the wrong way round')
      call tables(scene, axes, table)
      call more(solver, scene)
      call wrcdel(solver, ierr)
      call wrcdel(scene, ierr)
      end

c     Further arguments of a step, and static equilibrium.
      subroutine more(solver, scene)
      implicit none
      integer*8 scene, solver
      integer ierr, istate(2), iopt(5)
      real*8 q(6), v(6), f(6,2), g(6,2), opt(15), value, loads(2)
      real*8 dfdq(6,6,2), dfdv(6,6,2), dfdr(6,3,2), dfdw(6,3,2)
      data q /0.0d0, 3.0d0, 459.815d0, 1.8d-4, 0.0d0, 1.0d-3/
      data v /2.0d4, 15.0d0, 1.0d0, 2.0d-3, 43.5d0, -5.0d-3/
      data iopt /0, 0, 0, 1, 1/
      data loads /9.0d4, 5.0d4/
      save
      opt(14) = 0.2d0
      opt(15) = 0.4d0
      call wrcvex(solver, scene, q, v, iopt, opt, f, dfdq, dfdv, dfdr,
     &  dfdw, istate, ierr)
      call expect(ierr .eq. 0, 'a step with more arguments')
      call wrcget(scene, 'friction.right', value, ierr)
      call expect(abs(value - 0.4d0) .le. 0.0d0, 'friction stays')
      call expect(abs(dfdr(3,2,1) + dfdq(3,3,1)) .le. 0.0d0 .and.
     &  abs(dfdw(2,1,2) + dfdv(2,2,2)) .le. 0.0d0,
     &  'a rail moves against the wheel')
      iopt(5) = 0
      call wrceql(solver, scene, 0, loads, 1, v, iopt, opt, q, f, dfdq,
     &  dfdv, dfdr, dfdw, istate, ierr)
      call expect(ierr .eq. 0 .and. abs(f(3,1) - 9.0d4) .lt. 2.0d1
     &  .and. abs(f(3,2) - 5.0d4) .lt. 2.0d1, 'wheels carry loads')
      call wrcvex(solver, scene, q, v, iopt, opt, g, dfdq, dfdv, dfdr,
     &  dfdw, istate, ierr)
      call expect(abs(f(2,1) - g(2,1)) .le. 0.0d0, 'the same bits')
      end

      subroutine tables(scene, axes, table)
      implicit none
      integer*8 scene
      integer counts(2), ierr, i
      real*8 axes(5), table(2,6), value
      character*120 text
      call wrcstx(scene, 'pose.vertical', 'solve', ierr)
      call wrcstx(scene, 'pose.roll', 'solve', ierr)
      counts(1) = 3
      counts(2) = 2
      ierr = -1
      call wrctab(scene, 'pose.lateral pose.yaw', axes, counts, 2,
     &  'left.lateral_force roll', 1, ' ', table, ierr)
      call expect(ierr .eq. 0, 'a table')
      call wrcset(scene, 'pose.lateral', axes(3), ierr)
      call wrcset(scene, 'pose.yaw', axes(4), ierr)
      call wrcsol(scene, ierr)
      call wrcnum(scene, 'left.lateral_force', value, ierr)
      call expect(abs(table(1,3) - value) .le. 0.0d0,
     &  'the third combination')
      call wrcset(scene, 'pose.yaw', axes(5), ierr)
      call wrcsol(scene, ierr)
      call wrcnum(scene, 'roll', value, ierr)
      call expect(abs(table(2,6) - value) .le. 0.0d0, 'the last one')
      call wrctab(scene, 'pose.lateral pose.yaw', axes, counts, 2,
     &  'left.farce roll', 1, 'table.txt', table, ierr)
      call wrcerr(scene, text, i)
      call expect(ierr .eq. 2 .and. index(text, 'left.farce') .gt. 0,
     &  'no such result')
      end
