package org.urbi.kernel.uobject;

import static java.util.Objects.requireNonNull;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.WeakHashMap;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Inbox;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Forgotten;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.SlotData;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.World;
import org.urbi.kernel.variable.UrbiUVar;
import urbi.UClass;

/** The UObjects of one kernel, by their names: slots of {@code uobjects}. */
final class Instances {
  private final World world;
  private final Inbox inbox;
  private final Journal journal;
  private final Consumer<Instance> onGone;
  private final Map<String, Instance> byName = new LinkedHashMap<>();
  private final Map<UrbiObject, Instance> byObject = new WeakHashMap<>();

  /**
   * @param onGone called for each one whose urbiscript object was garbage collected
   */
  Instances(World world, Inbox inbox, Journal journal, Consumer<Instance> onGone) {
    this.world = world;
    this.inbox = inbox;
    this.journal = journal;
    this.onGone = onGone;
  }

  private UrbiObject namespace() {
    return world.prototype("uobjects");
  }

  /** Registers an object, under a name that no other one has. */
  Instance add(String name, UClass type, UrbiObject object, UrbiObject lobby) {
    Instance instance = new Instance(name, type, object, lobby, journal);
    byName.put(name, instance);
    byObject.put(object, instance);
    setSlot(object, world.symbol("__uobjectName"), world.values().string(Utf8Text.toUrbi(name)));
    return instance;
  }

  /** Tells urbiscript that an object is in the process of a client, and in which lobby that is. */
  void markRemote(String name, UrbiObject lobby) {
    UrbiObject object = find(name);
    if (object != null) {
      setSlot(object, world.symbol("isRemote"), world.values().trueObject);
      setSlot(object, world.symbol("lobby"), lobby);
    }
  }

  private static void setSlot(UrbiObject object, Symbol slot, UrbiObject value) {
    object.removeSlot(slot);
    object.addSlot(slot, value);
  }

  /** Makes it a slot of {@code uobjects} that does not keep the object alive. */
  void publish(Instance instance) {
    if (instance.isPublished()) {
      return;
    }
    instance.setPublished();
    UrbiObject namespace = namespace();
    Symbol slot = world.symbol(Utf8Text.toUrbi(instance.name()));
    setSlot(namespace, slot, world.values().voidObject);
    SlotData data = namespace.ensureSlotData(slot);
    data.setGetter(new Named(world.prototype("Code").cloneShape(), instance));
    namespace.slotDataChanged(slot);
    String name = instance.name();
    Forgotten.whenGone(present(instance), () -> inbox.post(new Message.ComponentGone(name)));
  }

  /** Makes it a slot of {@code uobjects} that keeps the object alive. */
  void publishClass(Instance instance) {
    setSlot(namespace(), world.symbol(Utf8Text.toUrbi(instance.name())), present(instance));
  }

  /** Makes an object that has ended a slot of {@code uobjects}, unless there is another one. */
  void showEnded(String name, UrbiObject object) {
    Symbol slot = world.symbol(Utf8Text.toUrbi(name));
    if (namespace().localSlot(slot) == null) {
      setSlot(namespace(), slot, object);
    }
  }

  private static UrbiObject present(Instance instance) {
    return requireNonNull(instance.object(), "it has just been made");
  }

  /** The urbiscript object of that name was reported as garbage collected. */
  void gone(String name) {
    Instance instance = byName.get(name);
    if (instance != null && instance.object() == null) {
      onGone.accept(instance);
    }
  }

  /** Forgets an object. */
  void remove(Instance instance) {
    byName.remove(instance.name());
    UrbiObject object = instance.object();
    if (object != null) {
      byObject.remove(object);
    }
    namespace().removeSlot(world.symbol(Utf8Text.toUrbi(instance.name())));
  }

  /** The instance of that name, or null. */
  @Nullable Instance named(String name) {
    return byName.get(name);
  }

  /** The urbiscript object of that name, or null. */
  @Nullable UrbiObject find(String name) {
    Instance instance = byName.get(name);
    return instance == null ? null : instance.object();
  }

  /** The instance of that very object, or null. */
  @Nullable Instance of(UrbiObject object) {
    return byObject.get(object);
  }

  /** The name of an object, or null if it is no UObject. */
  @Nullable String nameOf(UrbiObject object) {
    Instance instance = byObject.get(object);
    return instance == null ? null : instance.name();
  }

  /** The instance of an object or of its nearest ancestor that has one; or null. */
  @Nullable Instance nearest(UrbiObject object) {
    Instance own = byObject.get(object);
    if (own != null) {
      return own;
    }
    for (UrbiObject proto : object.protos()) {
      if (proto.isA(world.prototype("UObject"))) {
        Instance found = nearest(proto);
        if (found != null) {
          return found;
        }
      }
    }
    return null;
  }

  /**
   * Has an object keep a variable: the one whose slot it provides, or else the one whose component
   * uses it. Then nobody else needs to, and the variable may lead to the object. False if neither
   * is one of these objects.
   *
   * @param user null if that is not known
   */
  boolean keep(UrbiUVar variable, @Nullable UrbiObject user) {
    return keepsFor(variable.owner(), variable) || keepsFor(user, variable);
  }

  private boolean keepsFor(@Nullable UrbiObject keeper, UrbiUVar variable) {
    Instance instance = keeper == null ? null : byObject.get(keeper);
    if (instance == null) {
      return false;
    }
    instance.keep(variable);
    return true;
  }

  /** All of them, the oldest first. */
  List<Instance> all() {
    return List.copyOf(byName.values());
  }

  /** The value of the slot of {@code uobjects} that has the name of an object. */
  private static final class Named extends Code {
    private final Instance instance;

    Named(Shape shape, Instance instance) {
      super(shape);
      this.instance = instance;
    }

    @Override
    public boolean isLazy() {
      return false;
    }

    @Override
    public UrbiObject call(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
      UrbiObject object = instance.object();
      if (object == null) {
        throw caller.interpreter().errors().lookup(self, instance.name());
      }
      return object;
    }
  }
}
