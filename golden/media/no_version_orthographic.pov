// No version is said, so that of 3.62 holds with its method 3; orthographic, and a mirror shows the glow once more.
camera { orthographic location <0, 1.5, -6> look_at <0, 0.4, 0> right 4*x up 3*y }
light_source { <-4, 6, -4> rgb 0.8 }
plane { y, -0.8 pigment { rgb 0.1 } finish { reflection 0.7 ambient 0 } }
plane { -z, -4 pigment { rgb <0.25, 0.3, 0.45> } finish { ambient 1 diffuse 0 } }
sphere { <-0.7, 0.3, 0>, 0.8 hollow pigment { rgbt 1 }
  interior { media { emission <0.6, 0.3, 0.1> absorption 0.3 density { leopard scale 0.06 } } } }
box { <0.4, -0.5, -0.5>, <1.5, 0.8, 0.5> hollow pigment { rgbt 1 } rotate 12*y
  interior { media { absorption <0.3, 0.8, 1.5> } } }
