// A prism of triangles, lit through a union of targets.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.04 expand_thresholds 0.1, 20 } }
camera { location <1, 4, -6> look_at <0.5, 0.2, 0> right 4/3*x up y angle 42 }
light_source { <-5, 5, 0>, rgb <1, 1, 0.9> fade_distance 6 fade_power 2 photons { refraction on reflection on } }
plane { y, 0 pigment { checker rgb 0.9, rgb 0.6 } finish { ambient 0.05 diffuse 0.8 } }
#declare A = <0, 0, -1>; #declare B = <1, 0, -1>; #declare C = <0.5, 1, -1>; #declare U = 2*z;
union {
  mesh {
    triangle { A, B, C } triangle { A + U, C + U, B + U }
    triangle { A, B + U, B } triangle { A, A + U, B + U }
    triangle { B, C + U, C } triangle { B, B + U, C + U }
    triangle { C, A + U, A } triangle { C, C + U, A + U }
    inside_vector <0, 1, 0>
    translate 0.1*y
  }
  sphere { <-0.6, 0.5, 0.3>, 0.4 }
  pigment { rgbt <0.9, 1, 1, 1> } finish { ambient 0 diffuse 0 reflection 0.05 } interior { ior 1.5 }
  photons { target }
}
