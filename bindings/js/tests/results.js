/** What `native_solver` prints, computed by a solver of the package. */
export async function results(solver) {
  const last = solver.numberOfVertices - 1;
  const sources = [0, { face: last, coordinates: [0.25, 0.25, 0.5] }];
  const { distances, nearest, predecessors } = await solver.distances(sources, {
    nearest: true,
    predecessors: true,
  });
  const { points, length } = await solver.path(sources[1], { edge: [0, 1], parameter: 0.5 });
  const farthest = await solver.farthestPoints(10);
  const largest = distances.reduce((a, b) => Math.max(a, b));
  return {
    distances,
    nearest,
    predecessors,
    path: [...points, length],
    voronoi: await solver.voronoi(sources),
    farthestPoints: farthest.points,
    radius: [farthest.radius],
    matrix: (await solver.matrix(sources)).distances,
    gradient: await solver.gradient(distances),
    isolines: await solver.isolines(distances, largest / 2),
  };
}
