package examples.uobjectjava;

import urbi.UList;
import urbi.UObject;
import urbi.UValue;

/** What can be bound as a function: methods of this object and of others, with and without namesakes. */
public class Functions extends UObject {
  static {
    UStart(Functions.class);
  }

  /** Knows nothing of Urbi. */
  public static class Words {
    public String repeat(String word, int times) {
      return word.repeat(times);
    }
  }

  public Functions(String name) {
    super(name);
    UBindFunctions("count", "mixed");
    // Of two methods "half" the one with a double; its types tell which.
    UBindFunction(this, "half", new String[] {"double"});
    UBindFunction(new Words(), "repeat");
  }

  public int count(UList list) {
    return list.size();
  }

  /** Returns now this and now that. */
  public UValue mixed(boolean asText) {
    return asText ? new UValue("four") : new UValue(4);
  }

  public double half(double number) {
    return number / 2;
  }

  public String half(String text) {
    return text.substring(text.length() / 2);
  }
}
