package urbi;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * Groups UObjects that have something to do together (manual, "Using hubs to group objects"): a
 * subclass is declared by {@link UObject#UStartHub} and has one instance in each context, with
 * which objects register by {@link UObject#URegister}.
 */
public abstract non-sealed class UObjectHub extends UObjectBase {
  /** The objects that have registered, in the order in which they did. */
  public final List<UObject> members = new CopyOnWriteArrayList<>();

  private final String name;

  /**
   * @param name as it is given to the constructor of the subclass
   */
  protected UObjectHub(String name) {
    super(UContext.current());
    this.name = name;
  }

  /** The name of the class. */
  public String get_name() {
    return name;
  }

  @Override
  final String shownName() {
    return name;
  }

  /** The objects that have registered, in the order in which they did. */
  public List<UObject> getMembers() {
    return members;
  }

  /** The objects that have registered and are of that class. */
  public List<UObject> getSubClass(String className) {
    List<UObject> found = new ArrayList<>(members);
    found.removeIf(object -> !object.getClassname().equals(className));
    return found;
  }

  /** Takes an object in. */
  public void addMember(UObject object) {
    if (!members.contains(object)) {
      members.add(object);
    }
  }

  /** Takes an object out. */
  public void delMember(UObject object) {
    members.remove(object);
  }
}
