/*!
\ingroup PkgApproximateGeodesicsConcepts
\cgalConcept

The concept `DirectionalCostFunction` describes a function object that says what paths in a face
cost where this depends on their direction. `CGAL::Approximate_geodesics::directional_cost()` makes
a value of the named parameter `face_weight_map` of it.

It need not be convex: what counts are the costs of zigzags, where these are cheaper than straight
lines. It is called when the mesh is read, and not kept.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Approximate_geodesics::Hiking_time}
\cgalHasModels{CGAL::Approximate_geodesics::Walking_energy}
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
  returns what a path in `face` costs per unit of length, seconds per meter for instance: a number
  that is not negative, or infinity where paths must not go. `direction` is a unit vector in the
  plane of the face, a `%Vector_3` of the mesh's kernel, up to rounding. In a face without area, the
  plane is any that contains it.

  `Face` is the `face_descriptor` of the mesh, and the result converts to `double`.
  */
  template <typename Face, typename Vector_3>
  double operator()(Face face, const Vector_3& direction) const;
};
