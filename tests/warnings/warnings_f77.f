C     Solves the scenes of a file and prints their warnings, as a program
C     in FORTRAN 77 reads them. Lines of the file: as in warnings_c.c.
      PROGRAM WRNF77
      INTEGER*8 SCENE
      INTEGER IERR, I, L, N
      DOUBLE PRECISION PAIR(2), TOLD
      CHARACTER*1024 PATH, LINE, REST, TEXT
      CHARACTER*128 WORD, KEY, NAME
      EXTERNAL WRCNEW, WRCDEL, WRCSET, WRCSTX, WRCSTN, WRCSOL, WRCWRN
      EXTERNAL WRCNUM, STOPIF
      CALL GETARG(1, PATH)
      OPEN (10, FILE=PATH, STATUS='OLD')
      SCENE = 0
   10 READ (10, '(A)', END=90) LINE
      L = INDEX(LINE, ' ')
      WORD = LINE(1:L)
      REST = LINE(L+1:)
      L = INDEX(REST, ' ')
      KEY = REST(1:L)
      REST = REST(L+1:)
      IERR = 0
      IF (WORD .EQ. 'scene') THEN
        IF (SCENE .NE. 0) CALL WRCDEL(SCENE, IERR)
        CALL WRCNEW(SCENE, 'scene', KIND(0), IERR)
        NAME = KEY
      ELSE IF (WORD .EQ. 'number') THEN
        READ (REST, *) PAIR(1)
        CALL WRCSET(SCENE, KEY, PAIR(1), IERR)
      ELSE IF (WORD .EQ. 'list') THEN
        READ (REST, *) PAIR
        CALL WRCSTN(SCENE, KEY, PAIR, 2, IERR)
      ELSE IF (WORD .EQ. 'text') THEN
        CALL WRCSTX(SCENE, KEY, REST, IERR)
      ELSE
        CALL WRCSOL(SCENE, IERR)
        IF (IERR .EQ. 8) IERR = 0
        CALL STOPIF(IERR)
        CALL WRCNUM(SCENE, 'warning_count', TOLD, IERR)
        N = NINT(TOLD)
        DO 20 I = 1, N + 1
          CALL WRCWRN(SCENE, I, TEXT, IERR)
          CALL STOPIF(IERR)
          L = LEN_TRIM(TEXT)
          IF ((L .EQ. 0) .NEQV. (I .GT. N)) STOP 2
          IF (L .GT. 0) PRINT '(3A)', TRIM(NAME), CHAR(9), TEXT(1:L)
   20   CONTINUE
      END IF
      CALL STOPIF(IERR)
      GO TO 10
   90 IF (SCENE .NE. 0) CALL WRCDEL(SCENE, IERR)
      END

      SUBROUTINE STOPIF(IERR)
      INTEGER IERR
      IF (IERR .NE. 0) STOP 1
      END
