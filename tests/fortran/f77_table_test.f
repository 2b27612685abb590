c Steps of time with a history, and tables that state their error, by
c the F77 layer; part of f77_test.f. f77_reference.c does the same in C.
      subroutine mkstep(solver, scene)
      implicit none
      integer*8 solver, scene
      integer ierr
      call wrcopn(scene, 'scene', kind(0), 1.0d0, ierr)
      call wrcopn(solver, 'solver', kind(0), 1.0d0, ierr)
      call wrcset(scene, 'solve.accuracy', 1.0d-2, ierr)
      call wrcstx(scene, 'solve.accuracy_of', 'forces', ierr)
      end

c Two lists differ by a bound at most.
      subroutine within(a, b, n, bound, what)
      implicit none
      integer n, i
      real*8 a(n), b(n), bound
      character*(*) what
      do i = 1, n
        call expect(abs(a(i) - b(i)) .le. bound, what)
      end do
      end

c     A braked wheelset of 160 kN on a slope of 1 per cent: the implicit
c     method of Euler for its motion along the track.
      subroutine tstill
      implicit none
      integer*8 scene, solver, hist, saved
      integer ierr, istate(2), iopt(5), istep, iter
      real*8 q(6), v(6), f(6,2), g(6,2), opt(15), loads(2), dt, mass
      real*8 dfdq(6,6,2), dfdv(6,6,2), dfdr(6,3,2), dfdw(6,3,2)
      real*8 steady(6,2), other(6,6,2), before, rest, push, status
      character*80 text
      data loads /1.6d5, 0.0d0/, push /-1.6d3/, dt /1.0d-2/
      data q /6*0.0d0/, v /6*0.0d0/, iopt /5*0/, opt /15*0.0d0/
      save
      mass = loads(1)/9810.0d0
      call mkstep(solver, scene)
      call wrcnew(saved, 'HISTORY', kind(0), ierr)
      ierr = -1
      call wrcopn(hist, 'history', kind(0), 1.0d0, ierr)
      call expect(ierr .eq. 0, 'a history')
      call wrceql(solver, scene, 1, loads, 0, v, iopt, opt, q, f, dfdq,
     &  dfdv, dfdr, dfdw, istate, ierr)
      call wrcvex(solver, scene, q, v, iopt, opt, steady, dfdq, dfdv,
     &  dfdr, dfdw, istate, ierr)
      call expect(ierr .eq. 0, 'steady rolling')
      iopt(5) = 1
      do istep = 1, 10
        before = v(1)
        do iter = 1, 10
          istate(1) = -1
          istate(2) = -1
          ierr = -1
          call wrcvhx(solver, scene, hist, dt, q, v, iopt, opt, f,
     &      dfdq, dfdv, dfdr, dfdw, istate, ierr)
          call expect(ierr .eq. 0, 'a step of time')
          rest = push + f(1,1) + f(1,2) - mass*(v(1) - before)/dt
          if (abs(rest) .lt. 1.0d-3) goto 10
          v(1) = v(1) + rest/(mass/dt - dfdv(1,1,1) - dfdv(1,1,2))
        end do
   10   call expect(abs(rest) .lt. 1.0d-3, 'it is in balance')
        call expect(istate(1) .eq. 0 .and. istate(2) .eq. 0, 'states')
        call refhis(q, v, dt, g, other, status)
        call expect(status .le. 0.0d0, 'the reference')
        call within(f, g, 12, 0.0d0, 'forces as in C')
        call within(dfdv, other, 72, 0.0d0, 'derivatives as in C')
        ierr = -1
        call wrchac(hist, ierr)
        call expect(ierr .eq. 0, 'accepted')
        q(1) = q(1) + dt*v(1)
      end do
      call expect(abs(q(1)) .lt. 1.0d-3 .and. abs(v(1)) .lt. 1.0d-6,
     &  'it parks')
      call expect(abs(f(1,1) + f(1,2) + push) .lt. 1.0d-1, 'rails hold')
      ierr = -1
      call wrchcp(saved, hist, ierr)
      call expect(ierr .eq. 0, 'a copy')
      ierr = -1
      call wrchcl(hist, ierr)
      call expect(ierr .eq. 0, 'cleared')
      call wrcvhx(solver, scene, hist, dt, q, v, iopt, opt, f, dfdq,
     &  dfdv, dfdr, dfdw, istate, ierr)
      call expect(abs(f(1,1) + f(1,2)) .lt. 1.0d0, 'nothing is held')
      call wrcvhx(solver, scene, saved, dt, q, v, iopt, opt, f, dfdq,
     &  dfdv, dfdr, dfdw, istate, ierr)
      call refhis(q, v, dt, g, other, status)
      call within(f, g, 12, 0.0d0, 'the copy holds')
      v(1) = 0.0d0
      iopt(5) = 0
      call wrcvex(solver, scene, q, v, iopt, opt, f, dfdq, dfdv, dfdr,
     &  dfdw, istate, ierr)
      call within(f, steady, 12, 0.0d0, 'steady rolling as before')
c     What is refused.
      ierr = -1
      call wrcvhx(solver, scene, hist, 0.0d0, q, v, iopt, opt, f,
     &  dfdq, dfdv, dfdr, dfdw, istate, ierr)
      call wrcerr(scene, text, iter)
      call expect(ierr .eq. 1 .and. index(text, 'time_step') .eq. 1,
     &  'no time')
      ierr = -1
      call wrcvhx(solver, scene, solver, dt, q, v, iopt, opt, f, dfdq,
     &  dfdv, dfdr, dfdw, istate, ierr)
      call expect(ierr .eq. 1, 'a solver for a history')
      ierr = -1
      call wrchac(scene, ierr)
      call expect(ierr .eq. 1, 'a scene for a history')
      ierr = -1
      call wrchcp(hist, solver, ierr)
      call expect(ierr .eq. 1, 'a copy of a solver')
      ierr = -1
      call wrcdel(hist, ierr)
      call expect(ierr .eq. 0 .and. hist .eq. 0, 'given back')
      ierr = -1
      call wrchcl(hist, ierr)
      call expect(ierr .ne. 0, 'no handle')
      ierr = -1
      call wrchcp(saved, hist, ierr)
      call expect(ierr .eq. 1, 'a copy of no handle')
      ierr = -1
      call wrcvhx(solver, scene, hist, dt, q, v, iopt, opt, f, dfdq,
     &  dfdv, dfdr, dfdw, istate, ierr)
      call expect(ierr .ne. 0, 'a step with no handle')
      call within(f, steady, 12, 0.0d0, 'forces stay')
      call refhis(q, v, 0.0d0, g, other, status)
      call wrcdel(saved, ierr)
      call wrcdel(solver, ierr)
      call wrcdel(scene, ierr)
      end

      subroutine tctabl
      implicit none
      integer*8 scene, solver, ctable, other
      integer ierr, istate(2), iopt(5), i
      real*8 q(6), v(6), f(6,2), g(6,2), opt(15), loads(2), ranges(6)
      real*8 dfdq(6,6,2), dfdv(6,6,2), dfdr(6,3,2), dfdw(6,3,2)
      real*8 errors(2), facts(13), exact(6,2), byrail(6,3,2), bounds(2)
      real*8 xlikel(2,2), out(8,2), outerr(8,2), reflik(2,2)
      real*8 refout(8,2), outref(8,2)
      real*8 status
      character*120 text
      data ranges /1.0d0, 3.0d-3, 1.0d-2, 1.2d5, 0.0d0, 0.2d0/
      data loads /1.2d5, 0.0d0/, iopt /5*0/, opt /15*0.0d0/
      data q /0.0d0, 0.2d0, 3*0.0d0, 2.0d-3/
      data v /2.0d4, 10.0d0, 2*0.0d0, 43.5d0, 0.0d0/
      save
      call mkstep(solver, scene)
      ierr = -1
      call wrcopn(ctable, 'table', kind(0), 1.0d0, ierr)
      call expect(ierr .eq. 0, 'a handle of a table')
      call wrcnew(other, 'TABLE', kind(0), ierr)
      ierr = -1
      call wrctvx(ctable, 0_8, 0_8, q, v, iopt, opt, f, dfdq, dfdv,
     &  dfdr, dfdw, errors, istate, ierr)
      call wrcerr(ctable, text, i)
      call expect(ierr .eq. 10 .and. text .ne. ' ', 'it is empty')
      ierr = -1
      call wrctmk(ctable, scene, ranges, 1, ierr)
      call expect(ierr .eq. 0, 'it is made')
      ierr = -1
      call wrctfa(ctable, facts, ierr)
      call within(facts, ranges, 5, 0.0d0, 'its ranges')
      call expect(ierr .eq. 0 .and. facts(6) .gt. 1.0d2 .and. facts(11)
     &  .gt. facts(9) .and. facts(13) .gt. 1.0d4, 'facts')

c     The forces of a step, within the error.
      call wrceql(solver, scene, 1, loads, 1, v, iopt, opt, q, exact,
     &  dfdq, dfdv, dfdr, dfdw, istate, ierr)
      istate(1) = -1
      istate(2) = -1
      iopt(5) = 1
      ierr = -1
      call wrctvx(ctable, 0_8, 0_8, q, v, iopt, opt, f, dfdq, dfdv,
     &  dfdr, dfdw, errors, istate, ierr)
      call expect(ierr .eq. 0 .and. istate(1) .eq. 0 .and. istate(2)
     &  .eq. 0, 'a step by a table')
      do i = 1, 2
        call expect(errors(i) .gt. 0.0d0, 'an error')
        call within(f(1,i), exact(1,i), 3, 6.0d4*errors(i),
     &    'within its error')
        call expect(abs(dfdr(3,2,i) + dfdq(3,3,i)) .le.
     &    1.0d-6*abs(dfdq(3,3,i)), 'rails move against wheels')
      end do

c     With all arguments, from a file and by another handle.
      ierr = -1
      call wrctsv(ctable, 'f77.table', ierr)
      call expect(ierr .eq. 0, 'saved')
      ierr = -1
      call wrctsh(ctable, other, ierr)
      call expect(ierr .eq. 0, 'shared')
      do i = 1, 5
        iopt(i) = 1
      end do
      opt(2) = 0.02d0
      opt(8) = 0.5d0
      opt(13) = 1.0d-6
      opt(14) = 0.2d0
      opt(15) = 0.4d0
      call wrctvx(ctable, 0_8, 0_8, q, v, iopt, opt, f, dfdq, dfdv,
     &  dfdr, dfdw, errors, istate, ierr)
      call expect(ierr .eq. 0, 'all arguments')
      call reftab(q, v, opt, g, byrail, bounds, reflik, refout, outref,
     &  status)
      call expect(status .le. 0.0d0, 'the reference')
      call within(f, g, 12, 0.0d0, 'forces as in C')
      call within(dfdr, byrail, 36, 0.0d0, 'by the rails as in C')
      call within(errors, bounds, 2, 0.0d0, 'errors as in C')
      istate(1) = -1
      istate(2) = -1
      ierr = -1
      call wrctvo(ctable, 0_8, 0_8, q, v, iopt, opt, f, dfdq, dfdv,
     &  dfdr, dfdw, errors, xlikel, out, outerr, istate, ierr)
      call expect(ierr .eq. 0 .and. istate(1) .eq. 0 .and. istate(2)
     &  .eq. 0, 'outputs')
      call within(f, g, 12, 0.0d0, 'the same forces')
      call within(dfdr, byrail, 36, 0.0d0, 'the same derivatives')
      call within(errors, bounds, 2, 0.0d0, 'the same errors')
      call within(xlikel, reflik, 4, 0.0d0, 'likely errors as in C')
      call within(out, refout, 16, 0.0d0, 'outputs as in C')
      call within(outerr, outref, 16, 0.0d0, 'their errors as in C')
      do i = 1, 2
        call expect(xlikel(1,i) .gt. 0.0d0 .and. out(1,i) .gt. 0.0d0
     &    .and. out(5,i) .gt. 4.5d2 .and. out(6,i) .gt. 3.0d4 .and.
     &    outerr(1,i) .gt. 0.0d0, 'of both wheels')
      end do
      call wrctvx(other, 0_8, 0_8, q, v, iopt, opt, g, dfdq, dfdv,
     &  dfdr, dfdw, errors, istate, ierr)
      call expect(ierr .eq. 0, 'a step')
      call within(f, g, 12, 0.0d0, 'by the other handle')
      call wrcdel(ctable, ierr)
      call expect(ierr .eq. 0 .and. ctable .eq. 0, 'one is given back')
      call wrctvx(other, 0_8, 0_8, q, v, iopt, opt, g, dfdq, dfdv,
     &  dfdr, dfdw, errors, istate, ierr)
      call expect(ierr .eq. 0, 'a step')
      call within(f, g, 12, 0.0d0, 'and the other stays')
      call wrcopn(ctable, 'table', kind(0), 1.0d0, ierr)
      ierr = -1
      call wrctld(ctable, 'f77.table', ierr)
      call expect(ierr .eq. 0, 'loaded')
      call wrctvx(ctable, solver, scene, q, v, iopt, opt, g, dfdq, dfdv,
     &  dfdr, dfdw, errors, istate, ierr)
      call expect(ierr .eq. 0 .and. istate(1) .eq. 0, 'loaded')
      call within(f, g, 12, 0.0d0, 'from the file, with a solver')

c     Outside, and what is refused.
      q(6) = 0.02d0
      ierr = -1
      call wrctvx(ctable, 0_8, 0_8, q, v, iopt, opt, g, dfdq, dfdv,
     &  dfdr, dfdw, errors, istate, ierr)
      call wrcerr(ctable, text, i)
      call expect(ierr .eq. 1 .and. index(text, 'yaw') .gt. 0,
     &  'outside')
      call wrctvx(ctable, solver, scene, q, v, iopt, opt, g, dfdq, dfdv,
     &  dfdr, dfdw, errors, istate, ierr)
      call expect(ierr .eq. 0 .and. istate(1) .eq. 16 .and. istate(2)
     &  .eq. 16 .and. errors(1) .le. 0.0d0, 'solved exactly')
      q(6) = 2.0d-3
      ierr = -1
      call wrctvx(ctable, scene, solver, q, v, iopt, opt, g, dfdq, dfdv,
     &  dfdr, dfdw, errors, istate, ierr)
      call expect(ierr .eq. 1, 'the wrong way round')
      ierr = -1
      call wrctvx(ctable, solver, 0_8, q, v, iopt, opt, g, dfdq, dfdv,
     &  dfdr, dfdw, errors, istate, ierr)
      call expect(ierr .eq. 1, 'no scene with the solver')
      ierr = -1
      call wrctvx(solver, 0_8, 0_8, q, v, iopt, opt, g, dfdq, dfdv,
     &  dfdr, dfdw, errors, istate, ierr)
      call expect(ierr .eq. 1, 'no table')
      ierr = -1
      call wrctvo(solver, 0_8, 0_8, q, v, iopt, opt, g, dfdq, dfdv,
     &  dfdr, dfdw, errors, xlikel, out, outerr, istate, ierr)
      call expect(ierr .eq. 1, 'no outputs of no table')
      ierr = -1
      call wrctmk(ctable, solver, ranges, 1, ierr)
      call expect(ierr .eq. 1, 'a table of a solver')
      ierr = -1
      ranges(6) = 9.0d0
      call wrctmk(ctable, scene, ranges, 1, ierr)
      call wrcerr(ctable, text, i)
      call expect(ierr .eq. 1 .and. index(text, 'fineness') .gt. 0,
     &  'too fine')
      ierr = -1
      call wrctld(ctable, 'no.table', ierr)
      call expect(ierr .eq. 3, 'no file')
      ierr = -1
      call wrctsh(ctable, scene, ierr)
      call expect(ierr .eq. 1, 'shared with a scene')
      ierr = -1
      call wrctfa(scene, facts, ierr)
      call expect(ierr .eq. 1, 'facts of a scene')
      call wrctvx(ctable, 0_8, 0_8, q, v, iopt, opt, g, dfdq, dfdv,
     &  dfdr, dfdw, errors, istate, ierr)
      call expect(ierr .eq. 0, 'a step')
      call within(f, g, 12, 0.0d0, 'it keeps its table')
      call wrcdel(other, ierr)
      ierr = -1
      call wrctsv(other, 'none.table', ierr)
      call expect(ierr .ne. 0, 'no handle')
      call wrcdel(ctable, ierr)
      call wrcdel(solver, ierr)
      call wrcdel(scene, ierr)
      end
