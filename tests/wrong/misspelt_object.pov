// A keyword with a letter missing.
camera { location -5 * z look_at 0 }
shpere { 0, 1 pigment { rgb 1 } }
