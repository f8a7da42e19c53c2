//! Meshes: triangles one by one, or lists of points and indices.

use super::number::{push_f64, push_floats, push_vector, vector};
use super::writer::Writer;
use crate::scene::Mesh;
use std::fmt::Write as _;

/// How many entries of a list stand on a line.
const A_LINE: usize = 6;

impl Writer<'_> {
    /// The inside of `mesh` or `mesh2`.
    pub(super) fn mesh(&mut self, mesh: &Mesh) {
        if mesh.is_mesh2 {
            self.mesh2(mesh)
        } else {
            self.triangles(mesh)
        }
        if let Some(inside) = mesh.inside_vector {
            self.line(format_args!("inside_vector {}", vector(inside)));
        }
    }

    fn triangles(&mut self, mesh: &Mesh) {
        let Mesh { vertices, normals, uvs, faces, normal_indices, uv_indices, textures, face_textures, .. } = mesh;
        let names: Vec<String> =
            textures.iter().map(|texture| self.texture_name(texture, true).unwrap_or_default()).collect();
        if self.counting {
            return;
        }
        for (i, face) in faces.iter().enumerate() {
            let smooth = normal_indices.get(i).filter(|normals| normals[0] != u32::MAX);
            let mut text = String::new();
            for corner in 0..3 {
                text.push_str(if corner == 0 { "" } else { ", " });
                push_floats(&mut text, &vertices[face[corner] as usize]);
                if let Some(indices) = smooth {
                    text.push_str(", ");
                    push_floats(&mut text, &normals[indices[corner] as usize]);
                }
            }
            if let Some(corners) = uv_indices.get(i) {
                text.push_str(" uv_vectors ");
                for (corner, index) in corners.iter().enumerate() {
                    text.push_str(if corner == 0 { "" } else { ", " });
                    push_vector(&mut text, &uvs[*index as usize].to_array());
                }
            }
            match face_textures.get(i).copied().flatten().map(|three| three.map(|t| names[t as usize].as_str())) {
                None => {}
                Some([a, b, c]) if a == b && b == c => drop(write!(text, " texture {{ {a} }}")),
                Some([a, b, c]) => drop(write!(text, " texture_list {{ {a}, {b}, {c} }}")),
            }
            let word = if smooth.is_some() { "smooth_triangle" } else { "triangle" };
            self.line(format_args!("{word} {{ {text} }}"));
        }
    }

    fn mesh2(&mut self, mesh: &Mesh) {
        let Mesh {
            vertices,
            normals,
            uvs,
            faces,
            normal_indices,
            uv_indices,
            textures,
            face_textures,
            inside_vector: _,
            is_mesh2: _,
        } = mesh;
        self.list("vertex_vectors", vertices, |out, v| push_floats(out, v));
        self.list("normal_vectors", normals, |out, n| push_floats(out, n));
        self.list("uv_vectors", uvs, |out, uv| push_vector(out, &uv.to_array()));
        if !textures.is_empty() {
            self.open("texture_list");
            self.line(format_args!("{},", textures.len()));
            for texture in textures {
                // Layers are a texture of their own only by a name.
                self.inner_texture(texture);
            }
            self.close();
        }
        let mut textured = face_textures.iter();
        self.list("face_indices", faces, |out, face| {
            push_indices(out, face);
            match textured.next().copied().flatten() {
                None => {}
                Some([a, b, c]) if a == b && b == c => drop(write!(out, ", {a}")),
                Some([a, b, c]) => drop(write!(out, ", {a}, {b}, {c}")),
            }
        });
        self.list("uv_indices", uv_indices, push_indices);
        self.list("normal_indices", normal_indices, push_indices);
    }

    /// `WORD { n, entries }`; nothing for an empty list.
    fn list<T>(&mut self, word: &str, list: &[T], mut push: impl FnMut(&mut String, &T)) {
        if self.counting || list.is_empty() {
            return;
        }
        self.open(word);
        let mut line = format!("{}", list.len());
        for (i, entry) in list.iter().enumerate() {
            line.push(',');
            if i % A_LINE == 0 {
                self.line(&line);
                line.clear();
            } else {
                line.push(' ');
            }
            push(&mut line, entry);
        }
        self.line(line);
        self.close();
    }
}

fn push_indices(out: &mut String, face: &[u32; 3]) {
    for (i, index) in face.iter().enumerate() {
        out.push_str(if i == 0 { "<" } else { ", " });
        push_f64(out, f64::from(*index));
    }
    out.push('>');
}
