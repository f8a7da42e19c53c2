//! The words that begin objects, each with what stands in its braces.

use super::described::Table;
use super::modifiers::MODIFIERS;
use super::table::{Block, Item, Takes, Word};
use super::tables;
use crate::diag::SourceResult;
use crate::eval::Evaluator;
use crate::scene::Shape;
use crate::syntax::Keyword as K;

/// An object of one shape.
const fn shape(
    word: K,
    takes: &'static str,
    make: fn(&mut Evaluator<'_>, Word) -> SourceResult<Shape>,
    help: &'static str,
) -> Item<Shape> {
    Item::new(word, Takes::Whole(takes, make), "", help)
}

/// The same for one that came with version 3.5.
const fn late(
    word: K,
    takes: &'static str,
    make: fn(&mut Evaluator<'_>, Word) -> SourceResult<Shape>,
    help: &'static str,
) -> Item<Shape> {
    Item::since(350, word, Takes::Whole(takes, make), "", help)
}

/// Objects made of others, which are read before their word is looked up.
const fn compound(word: K, takes: &'static str, help: &'static str) -> Item<Shape> {
    Item::new(word, Takes::Elsewhere(takes), "", help)
}

/// Where the points end, the words of [`MODIFIERS`] and maybe others of the shape follow.
pub(super) static OBJECTS: Block<Shape> = Block::new(
    "objects",
    "what there is to be seen; in the place of … stand its own words and those of object",
    &[
        compound(K::Object, "{ OBJECT … }", "another object, changed"),
        compound(K::Union, "{ OBJECT, … }", "several objects together"),
        compound(K::Composite, "{ OBJECT, … }", "outdated: a union"),
        compound(K::Merge, "{ OBJECT, … }", "several objects as one, without walls where they overlap"),
        compound(K::Intersection, "{ OBJECT, … }", "what all of the objects have in common"),
        compound(K::Difference, "{ OBJECT, … }", "the first object without what the others take away"),
        Item::since(
            350,
            K::LightGroup,
            Takes::Elsewhere("{ OBJECT, … }"),
            "",
            "objects and the lights that light only them",
        ),
        shape(
            K::LightSource,
            "{ <PLACE>, COLOUR … }",
            |e, _| e.light_source(),
            "a light, which is nothing to see itself",
        ),
        shape(K::Sphere, "{ <CENTRE>, RADIUS … }", |e, _| e.sphere(), "a ball"),
        shape(K::Box, "{ <CORNER>, <CORNER> … }", |e, _| e.box_between(), "a box along the axes"),
        shape(K::Plane, "{ <NORMAL>, DISTANCE … }", |e, at| e.plane(at.span), "all on one side of a plane"),
        shape(
            K::Cylinder,
            "{ <END>, <END>, RADIUS [open] … }",
            |e, at| e.cylinder(at.span),
            "what is round about an axis",
        ),
        shape(
            K::Cone,
            "{ <END>, RADIUS, <END>, RADIUS [open] … }",
            |e, at| e.cone(at.span),
            "a cone, or what is left without its tip",
        ),
        shape(K::Disc, "{ <CENTRE>, <NORMAL>, RADIUS [, HOLE] … }", |e, _| e.disc(), "a flat disc, maybe with a hole"),
        shape(K::Torus, "{ MAJOR, MINOR … }", |e, _| e.torus(), "a ring in the plane of x and z"),
        Item::since(
            370,
            K::Ovus,
            Takes::Whole("{ BOTTOM, TOP … }", |e, at| e.ovus(at.span)),
            "",
            "an egg, by two radii",
        ),
        shape(
            K::Superellipsoid,
            "{ <EAST_WEST, NORTH_SOUTH> … }",
            |e, _| e.superellipsoid(),
            "a ball that is more or less of a box",
        ),
        shape(
            K::Quadric,
            "{ <xx, yy, zz>, <xy, xz, yz>, <x, y, z>, 1 … }",
            |e, _| e.quadric(),
            "where a polynomial of order 2 is below 0",
        ),
        shape(K::Cubic, "{ <20 FLOATS> … }", |e, _| e.polynomial_list(3), "where a polynomial of order 3 is below 0"),
        shape(K::Quartic, "{ <35 FLOATS> … }", |e, _| e.polynomial_list(4), "where a polynomial of order 4 is below 0"),
        shape(
            K::Poly,
            "{ ORDER, <FLOATS> … }",
            |e, _| {
                let order = e.polynomial_order()?;
                e.comma()?;
                e.polynomial_list(order)
            },
            "where a polynomial is below 0, all of its coefficients in order",
        ),
        Item::since(
            370,
            K::Polynomial,
            Takes::Whole("{ ORDER, xyz(I, J, K): FLOAT, … }", |e, _| e.polynomial_terms()),
            "",
            "where a polynomial is below 0, by the coefficients that are not 0",
        ),
        shape(K::Polygon, "{ N, <POINT>, … }", |e, at| e.polygon(at.span), "a flat outline; a first point ends it"),
        shape(K::Triangle, "{ <A>, <B>, <C> … }", |e, at| e.triangle(at.span), "a triangle"),
        shape(
            K::SmoothTriangle,
            "{ <A>, <NORMAL>, <B>, <NORMAL>, <C>, <NORMAL> … }",
            |e, at| e.smooth_triangle(at.span),
            "a triangle that is lit as if it were bent",
        ),
        shape(K::Mesh, "{ TRIANGLES … }", |e, at| e.mesh(at.span), "many triangles as one object"),
        late(K::Mesh2, "{ LISTS … }", |e, at| e.mesh2(at.span), "many triangles, by the numbers of their corners"),
        shape(K::HeightField, "{ IMAGE … }", |e, _| e.height_field(), "a landscape whose heights are a picture"),
        shape(K::Blob, "{ COMPONENTS … }", |e, at| e.blob(at.span), "balls and cylinders that flow into each other"),
        shape(
            K::BicubicPatch,
            "{ WORDS, 16 <POINT> … }",
            |e, at| e.bicubic_patch(at.span),
            "a bent surface over a grid of points",
        ),
        shape(
            K::Prism,
            "{ [SPLINE] [SWEEP] HEIGHT, HEIGHT, N, <POINT>, … [open] … }",
            |e, at| e.prism(at.span),
            "an outline in x and z, swept along y",
        ),
        shape(
            K::Lathe,
            "{ [SPLINE] N, <POINT>, … }",
            |e, at| e.lathe(at.span),
            "an outline in x and y, turned about y",
        ),
        shape(
            K::Sor,
            "{ N, <POINT>, … [open] … }",
            |e, at| e.sor(at.span),
            "an outline in x and y that rises, turned about y",
        ),
        late(
            K::SphereSweep,
            "{ SPLINE N, <CENTRE>, RADIUS, … }",
            |e, at| e.sphere_sweep(at.span),
            "what a ball goes through on its way",
        ),
        shape(
            K::Text,
            "{ ttf FILE | internal N, STRING, THICKNESS, <OFFSET> … }",
            |e, at| e.text(at.span),
            "letters with a thickness",
        ),
        late(K::Isosurface, "{ function { … } … }", |e, _| e.isosurface(), "where a function is below a threshold"),
        late(
            K::Parametric,
            "{ function { … }, function { … }, function { … } <U, V>, <U, V> … }",
            |e, _| e.parametric(),
            "a surface by three functions of u and v",
        ),
        shape(K::JuliaFractal, "{ <4 FLOATS> … }", |e, _| e.julia_fractal(), "a fractal of four dimensions, cut"),
    ],
);

/// Whether an object begins with this word.
pub(in crate::eval) fn is_object_keyword(word: K) -> bool {
    OBJECTS.knows(word)
}

/// The words that an object takes.
pub(super) fn words_in(word: K) -> &'static dyn Table {
    tables().find(|table| table.name() == word.word()).unwrap_or(&MODIFIERS)
}
