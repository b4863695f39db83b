// Amounts as textures that a shader reads by number, row by row.
import { DataTexture, FloatType, NearestFilter, RedFormat, RGBAIntegerFormat, UnsignedIntType } from "three";
import { WIDTH } from "./strandshaders";

/** Rows of a texture that holds so many texels. */
function rowsFor(count: number): number {
  return Math.max(Math.ceil(count / WIDTH), 1);
}

/** Strands, four numbers each; see view_texels.py. */
export function texels(strands: Uint32Array): DataTexture {
  const rows = rowsFor(strands.length / 4);
  const filled = new Uint32Array(WIDTH * rows * 4);
  filled.set(strands);
  const texture = new DataTexture(filled, WIDTH, rows, RGBAIntegerFormat, UnsignedIntType);
  texture.internalFormat = "RGBA32UI";
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

/** One number each. */
export function amounts(shares: Float32Array): DataTexture {
  const rows = rowsFor(shares.length);
  const filled = new Float32Array(WIDTH * rows);
  filled.set(shares);
  const texture = new DataTexture(filled, WIDTH, rows, RedFormat, FloatType);
  texture.internalFormat = "R32F";
  texture.needsUpdate = true;
  return texture;
}
