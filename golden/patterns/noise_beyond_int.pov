// turbulence whose octaves reach coordinates beyond 2^31: cells of the noise end there.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4,0,-5> look_at <4,0,0> right 4*x up 3*y }
plane { -z, 0
  pigment { bumps turbulence 0.5 octaves 6 lambda 64 color_map { [0 rgb 0][1 rgb 1] } }
  finish { ambient 1 diffuse 0 } }
