// Expressions come back as they were folded; what they share becomes a function.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -4*z look_at 0 }
light_source { -9*z, 1 }
#declare Bumps = function { pigment { bozo scale 0.3 } }
#declare Path = spline { cubic_spline 0, <0, 0, 0>, 0.5, <1, 1, 0>, 1, <2, 0, 0>, 1.5, <3, 1, 1> }
#declare F = function(x, y, z, k) { sqrt(x*x + y*y + z*z) - k - 0.1*Bumps(x, y, z).red }
#declare G = function { pow(F(x, y, z, 1) + 2*F(x, y, z, 1)*sin(x), 2) }
isosurface {
  function { G(x, y, z)*G(x, y, z) - select(x, 0.1, 0.2) + sum(i, 1, 3, x/i) }
  contained_by { sphere { 0, 2 } }
  pigment { function { max(Path(x).y, -y) & (z > 0) } }
}
