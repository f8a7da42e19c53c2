// A modifier before the last child of a CSG.
union {
  sphere { 0, 1 }
  pigment { rgb 1 }
  box { -1, 1 }
}
