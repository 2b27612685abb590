% Runs the tests of a file and says by the exit code whether all have passed; the second argument is
% the program of the reference values.
arguments = argv ();
global reference
[failed, reference] = system (['"' arguments{end} '"']);
[passed, count] = test (arguments{end - 1}, 'quiet', stdout ());
printf ('%d of %d passed\n', passed, count);
exit (failed || count == 0 || passed < count);
