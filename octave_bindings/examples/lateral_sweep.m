% Largest pressure of both wheels over the lateral displacement, on two threads.
lateral = -5:0.5:5;
scenes = struct ('pose', num2cell (struct ('lateral', num2cell (lateral))));
r = wrc_solve (scenes, 'solve.accuracy', 1e-2, 'threads', 2, 'fields', '');
left = arrayfun (@(one) one.left.pmax, r);
right = arrayfun (@(one) one.right.pmax, r);
for k = 1:numel (lateral)
  printf ('%5.1f mm: %7.1f %7.1f MPa\n', lateral(k), left(k), right(k));
end
