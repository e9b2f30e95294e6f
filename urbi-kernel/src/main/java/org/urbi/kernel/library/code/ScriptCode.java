package org.urbi.kernel.library.code;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.compile.Compilation;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Function;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.parse.UrbiParser;

/**
 * A function of the library written in urbiscript. It is parsed when it is first called or shown,
 * so that starting a kernel parses nothing.
 */
public final class ScriptCode extends Code {
  private final String text;
  private Ast.@Nullable Function tree;
  private @Nullable Function function;

  public ScriptCode(Shape shape, String text) {
    super(shape);
    this.text = text;
  }

  /** The function as a tree, for printing. */
  Ast.Function tree() {
    if (tree == null) {
      Ast.Sequence program = UrbiParser.parse(text, null).sequence();
      tree = (Ast.Function) program.statements().getFirst();
    }
    return tree;
  }

  @Override
  public boolean isLazy() {
    return tree().formals() == null;
  }

  @Override
  public UrbiObject call(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
    if (function == null) {
      Compilation.Compiled compiled = Compilation.compile(caller.interpreter(), tree());
      Frame frame = caller.nested(site, caller.self(), compiled.layout());
      UrbiObject system = caller.interpreter().values().object;
      // It is everybody's from now on, and not bound to the lobby of its first caller.
      function =
          (Function) caller.job().identity().doFor(system, () -> compiled.code().execute(frame));
    }
    return function.call(caller, site, self, arguments);
  }

  @Override
  public UrbiObject cloned() {
    return new ScriptCode(cloneShape(), text);
  }
}
