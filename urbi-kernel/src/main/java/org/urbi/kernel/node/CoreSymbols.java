package org.urbi.kernel.node;

import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.World;

/** The names that the interpreter itself looks up. */
public final class CoreSymbols {
  public final Symbol apply;
  public final Symbol asBool;
  public final Symbol asPrintable;
  public final Symbol asString;
  public final Symbol clone;
  public final Symbol each;
  public final Symbol eachConcurrent;
  public final Symbol eachTight;
  public final Symbol equals;
  public final Symbol fallback;
  public final Symbol init;
  public final Symbol matchAgainst;
  public final Symbol parentheses;
  public final Symbol type;

  CoreSymbols(World world) {
    apply = world.symbol("apply");
    asBool = world.symbol("asBool");
    asPrintable = world.symbol("asPrintable");
    asString = world.symbol("asString");
    clone = world.symbol("clone");
    each = world.symbol("each");
    eachConcurrent = world.symbol("each&");
    eachTight = world.symbol("each|");
    equals = world.symbol("==");
    fallback = world.symbol("fallback");
    init = world.symbol("init");
    matchAgainst = world.symbol("matchAgainst");
    parentheses = world.symbol("()");
    type = world.symbol("type");
  }
}
