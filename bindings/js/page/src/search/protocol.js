/**
 * Messages between the page and the worker that searches. The page sends a list of requests, and waits for the
 * answers, which come together. No other list waits in a queue: the next one is about the newest positions.
 *
 * @typedef {import('../types.js').Method} Method
 * @typedef {import('../types.js').SurfacePoint} SurfacePoint
 *
 * @typedef {{method: Method, epsilon: number, sources: SurfacePoint[]}} Question
 *
 * @typedef {{verb: 'load', vertices: Float64Array, faces: Int32Array}} LoadRequest
 * @typedef {{verb: 'paint', costs: import('../types.js').Costs}} PaintRequest
 * @typedef {{verb: 'distances', showsErrors: boolean, reuse: ArrayBuffer[]} & Question} DistancesRequest
 * @typedef {{verb: 'path', target: SurfacePoint, straighten: boolean} & Question} PathRequest
 * @typedef {{verb: 'compare'} & Question} CompareRequest
 * @typedef {{verb: 'spread', number: number, first: number}} SpreadRequest vertices that are far from each other
 * @typedef {LoadRequest | PaintRequest | DistancesRequest | PathRequest | CompareRequest | SpreadRequest} Request
 *
 * @typedef {object} Times
 * @property {number} milliseconds of the search
 * @property {number | undefined} build milliseconds of building the graph, if it was built now
 *
 * @typedef {object} DistancesOnly
 * @property {Float32Array} values a distance or a relative error for each vertex, -1 if it is not reached
 * @property {Float32Array} cells the number of the nearest source of each vertex
 * @property {number} mean value
 * @property {number} largest value
 * @property {number} unreached number of vertices
 *
 * @typedef {{points: Float64Array, length: number}} PathOnly points are empty if there is no path
 * @typedef {{mean: number, largest: number}} ErrorsOnly relative ones, of vertices
 *
 * @typedef {DistancesOnly & Times} DistancesAnswer
 * @typedef {PathOnly & Times} PathAnswer
 * @typedef {ErrorsOnly & Times} CompareAnswer
 *
 * @typedef {{answer?: any, failure?: string}} Answer
 * @typedef {{kind: 'building', method: Method} | {kind: 'answers', answers: Answer[]} |
 *   {kind: 'failure', message: string}} WorkerMessage the first answers are none: the worker is ready
 */
export {};
