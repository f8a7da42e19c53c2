#declare O = difference { box { -1, 1 } sphere { 0, 1.2 inverse } rotate 20 * x }
#declare N = <0, 0, 0>;
#declare H = trace(O, <0.2, 0.3, -5>, z, N);
#declare L = min_extent(O) + max_extent(O) * inside(O, H);
#declare R = seed(12);
#for (I, 1, 5)
  sphere { vrotate(<rand(R), rand(R), rand(R)>, 360 * rand(R)) + vaxis_rotate(x, y, 90) + vcross(H, N), vdot(x, x) / (1 + vlength(L)) }
#end
#declare U = vturbulence(2, 0.5, 6, <0.1, 0.2, 0.3>) + eval();
