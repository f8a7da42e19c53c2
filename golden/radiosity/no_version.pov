// Neither version nor gamma: everything as POV-Ray takes it.
global_settings { radiosity { count 50 } }
camera { location <0, 1.5, -4.5> look_at <0, 1.2, 0> right 4/3*x up y angle 65 }

#declare Wall = finish { diffuse 0.8 }
light_source { <0.5, 2.6, -1>, rgb 0.7 fade_distance 2 fade_power 2 }
box { <-2, 0, -5>, <2, 3, 2> hollow pigment { rgb 0.9 } finish { Wall } }
box { <-2, 0, -5>, <-1.98, 3, 2> pigment { rgb <0.9, 0.3, 0.2> } finish { Wall } }
box { <1.98, 0, -5>, <2, 3, 2> pigment { rgb <0.2, 0.4, 0.9> } finish { Wall } }

sphere { <0.4, 0.8, 0>, 0.8 pigment { rgb 0.8 } finish { Wall } }
