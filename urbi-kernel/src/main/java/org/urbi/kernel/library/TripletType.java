package org.urbi.kernel.library;

import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiTuple;
import org.urbi.kernel.object.World;

/** Tuples of three objects (manual, "Triplet"). */
@UrbiType(value = "Triplet", protos = "Tuple", doc = "A tuple of three objects.")
final class TripletType {
  private TripletType() {}

  static UrbiObject newPrototype(World world) {
    UrbiObject nil = world.values().nil;
    return new UrbiTuple(world.values().tupleProto.cloneShape(), List.of(nil, nil, nil));
  }

  @Builtin(doc = "Makes the arguments the members.")
  static UrbiObject init(UrbiTuple self, UrbiObject first, UrbiObject second, UrbiObject third) {
    self.setElements(List.of(first, second, third));
    return self;
  }

  @Builtin(doc = "The first member.")
  static UrbiObject first(UrbiTuple self) {
    return self.get(0);
  }

  @Builtin(doc = "The second member.")
  static UrbiObject second(UrbiTuple self) {
    return self.get(1);
  }

  @Builtin(doc = "The third member.")
  static UrbiObject third(UrbiTuple self) {
    return self.get(2);
  }
}
