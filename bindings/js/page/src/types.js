/**
 * Types that several modules share.
 *
 * @typedef {'edges' | 'epsilon' | 'exact'} Method
 * How distances are computed: along edges, within an error bound, or exactly.
 *
 * @typedef {{face: number, coordinates: [number, number, number]}} SurfacePoint
 * A point of a face, by its barycentric coordinates.
 *
 * @typedef {object} Mesh
 * @property {string} name what the page calls it
 * @property {string} unit the unit of coordinates, empty if it is unknown
 * @property {Float64Array} vertices three coordinates each
 * @property {Int32Array} faces three vertices each
 * @property {string[]} notes what the reader has changed
 *
 * @typedef {object} Frame
 * The similarity from coordinates of the mesh to those of the picture, in which the surface is in the
 * unit ball, and y is upward.
 * @property {[number, number, number]} center
 * @property {number} scale
 * @property {boolean} zIsUp
 *
 * @typedef {object} PreparedMesh
 * A mesh with what the picture needs, computed beside the page's thread.
 * @property {Mesh} mesh
 * @property {Frame} frame
 * @property {Float32Array} positions of vertices in the picture
 * @property {Float32Array} normals
 * @property {import('three-mesh-bvh').SerializedBVH} bvh
 *
 * @typedef {object} Costs
 * What the user has painted.
 * @property {Float64Array | undefined} faceWeights
 * @property {Int32Array | undefined} barriers pairs of vertices
 */

/** @type {readonly Method[]} */
export const METHODS = ['edges', 'epsilon', 'exact'];
