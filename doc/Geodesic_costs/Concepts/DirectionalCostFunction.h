/*!
\ingroup PkgGeodesicCostsConcepts
\cgalConcept

The concept `DirectionalCostFunction` describes a function object for costs of paths in a face that
depend on the direction. `CGAL::Approximate_geodesics::directional_cost()` converts it to a value of
the named parameter `face_weight_map`.

It need not be convex: where zigzags are cheaper than straight lines, their costs count. So infinity
for a direction forbids only to walk straight on in it; the named parameter `max_slope` forbids
slopes for good. The function is called when the mesh is read, and not stored.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Hiking_time}
\cgalHasModels{CGAL::Approximate_geodesics::Walking_energy}
\cgalHasModels{CGAL::Approximate_geodesics::Naismith_time}
\cgalHasModels{CGAL::Approximate_geodesics::Drift_time<FaceVectorMap>}
\cgalHasModels{CGAL::Approximate_geodesics::One_way<FaceVectorMap>}
\cgalHasModels{CGAL::Approximate_geodesics::Tensor_cost<FaceTensorMap>}
\cgalHasModels{CGAL::Approximate_geodesics::Reversed_cost<CostFunction>}
\cgalHasModelsEnd
*/
class DirectionalCostFunction
{
public:
  /*!
  returns the cost of a path in `face` per unit of length, in seconds per meter for instance: a
  number that is not negative, or infinity for directions in which no straight line may lead.
  `direction` is a unit vector in
  the plane of the face, up to rounding, a `%Vector_3` of the mesh's kernel. For a face without
  area, the plane is any that contains it.

  `Face` is the `face_descriptor` of the mesh, and the result converts to `double`.
  */
  template <typename Face, typename Vector_3>
  double operator()(Face face, const Vector_3& direction) const;
};
