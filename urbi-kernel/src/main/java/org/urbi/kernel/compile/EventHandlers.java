package org.urbi.kernel.compile;

import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.AtCondition;
import org.urbi.kernel.event.AtEvent;
import org.urbi.kernel.event.Condition;
import org.urbi.kernel.event.EventFilter;
import org.urbi.kernel.event.Every;
import org.urbi.kernel.event.WaitUntil;
import org.urbi.kernel.event.Whenever;
import org.urbi.kernel.job.TagState;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Pattern;
import org.urbi.kernel.node.Variables;
import org.urbi.kernel.tag.ConditionalTag;
import org.urbi.kernel.tag.ImplicitTag;
import org.urbi.kernel.tag.Tagged;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.ast.Ast.Flavor;

/** Compiles tags, and what waits for events and conditions. */
final class EventHandlers {
  private final Compilation compilation;

  EventHandlers(Compilation compilation) {
    this.compilation = compilation;
  }

  private Node compile(Ast ast, LexicalScope block) {
    return compilation.operand(ast, block);
  }

  private @Nullable Node optional(@Nullable Ast ast, LexicalScope block) {
    return compilation.optional(ast, block);
  }

  private Node handler(Ast ast, LexicalScope block) {
    return compilation.compile(ast, block, HandledJumps.ALL);
  }

  private @Nullable Node optionalHandler(@Nullable Ast ast, LexicalScope block) {
    return ast == null ? null : handler(ast, block);
  }

  // ------------------------------------------------------------------ tags

  Node tagged(Ast.Tagged tagged, LexicalScope block, HandledJumps seen) {
    // Tagged code has its own variables, except where {@code var} declares slots.
    LexicalScope inner = block.declaresSlots() ? block : block.construct();
    return new Tagged(
        tagged.span(), tag(tagged.tag(), block), compilation.compile(tagged.body(), inner, seen));
  }

  /** A tag that does not exist yet is created on first use. */
  private Node tag(Ast tag, LexicalScope block) {
    if (tag instanceof Ast.Message message && message.arguments() == null) {
      boolean local = message.target() == null && block.find(message.name()) != null;
      if (!local) {
        return new ImplicitTag(
            tag.span(),
            compilation.interpreter(),
            message.target() == null ? null : tag(message.target(), block),
            message.name(),
            compile(tag, block));
      }
    }
    return compile(tag, block);
  }

  Node timeout(Ast.Timeout timeout, LexicalScope block, HandledJumps seen) {
    return new ConditionalTag.Timeout(
        timeout.span(),
        compile(timeout.duration(), block),
        compilation.compile(timeout.body(), block, seen));
  }

  Node stopIf(Ast.StopIf watched, LexicalScope block, HandledJumps seen) {
    var scheduler = compilation.interpreter().scheduler();
    var nothing = compilation.interpreter().values().voidObject;
    // The tag is used only once, so it may stay blocked. A condition that holds from the start ends
    // the code after its first step.
    return watched(
        watched,
        watched.condition(),
        watched.body(),
        tag -> tag.block(scheduler, nothing),
        null,
        block,
        seen);
  }

  Node freezeIf(Ast.FreezeIf watched, LexicalScope block, HandledJumps seen) {
    return watched(
        watched,
        watched.condition(),
        watched.body(),
        TagState::freeze,
        TagState::unfreeze,
        block,
        seen);
  }

  private Node watched(
      Ast ast,
      Ast.Condition condition,
      Ast body,
      Consumer<TagState> enter,
      @Nullable Consumer<TagState> leave,
      LexicalScope block,
      HandledJumps seen) {
    LexicalScope inner = block.construct();
    LocalVariable variable = compilation.declare(inner, "<controlled>", ast);
    Variables.Place place = compilation.place(variable, inner);
    Node tag = compilation.read(ast.span(), variable, inner);
    Node watchdog =
        at(
            ast,
            condition,
            inner,
            inner.job(compilation.newRegion()),
            () -> new ConditionalTag.Control(ast.span(), tag, enter),
            () -> leave == null ? null : new ConditionalTag.Control(ast.span(), tag, leave),
            true);
    return new ConditionalTag.StopOrFreezeIf(
        ast.span(), place, watchdog, compilation.compile(body, inner, seen));
  }

  // ------------------------------------------------------------------ conditions

  private EventFilter filter(Ast.WhenEmitted condition, LexicalScope block) {
    Pattern[] patterns =
        condition.patterns() == null
            ? null
            : condition.patterns().stream()
                .map(pattern -> compilation.expressions.pattern(pattern, block))
                .toArray(Pattern[]::new);
    return new EventFilter(patterns, optional(condition.guard(), block));
  }

  Node at(Ast.At at, LexicalScope block) {
    LexicalScope inner = block.job(compilation.newRegion());
    return at(
        at,
        at.condition(),
        block,
        inner,
        () -> handler(at.body(), inner),
        () -> optionalHandler(at.onLeave(), inner),
        at.sync());
  }

  /** The clauses are compiled after the patterns of the condition, whose variables they see. */
  private Node at(
      Ast ast,
      Ast.Condition condition,
      LexicalScope block,
      LexicalScope inner,
      Supplier<Node> body,
      Supplier<@Nullable Node> onLeave,
      boolean sync) {
    Node duration = optional(condition.duration(), block);
    if (condition instanceof Ast.WhenEmitted emitted) {
      Node event = compile(emitted.event(), block);
      EventFilter filter = filter(emitted, inner);
      return new AtEvent(ast.span(), event, filter, duration, body.get(), onLeave.get(), sync);
    }
    Node expression = compile(((Ast.WhenTrue) condition).expression(), inner);
    return new AtCondition(ast.span(), expression, duration, body.get(), onLeave.get(), sync);
  }

  Node whenever(Ast.Whenever whenever, LexicalScope block) {
    LexicalScope inner = block.job(compilation.newRegion());
    Condition condition;
    if (whenever.condition() instanceof Ast.WhenEmitted emitted) {
      EventFilter filter = filter(emitted, inner);
      condition = new Condition.WhenEmitted(compile(emitted.event(), block), filter);
    } else {
      Ast.WhenTrue holds = (Ast.WhenTrue) whenever.condition();
      condition = new Condition.WhenTrue(compile(holds.expression(), inner));
    }
    return new Whenever(
        whenever.span(),
        condition,
        optional(whenever.condition().duration(), block),
        handler(whenever.body(), inner),
        optionalHandler(whenever.elseClause(), inner));
  }

  Node waitUntil(Ast.WaitUntil wait, LexicalScope block) {
    if (wait.condition() instanceof Ast.WhenEmitted emitted) {
      return compilation.expressions.matching(
          block,
          inner ->
              new WaitUntil(
                  wait.span(),
                  new Condition.WhenEmitted(
                      compile(emitted.event(), block), filter(emitted, inner)),
                  optional(emitted.duration(), block)));
    }
    Ast.WhenTrue holds = (Ast.WhenTrue) wait.condition();
    return new WaitUntil(
        wait.span(),
        // Another job evaluates it, so the variables that it reads are shared.
        new Condition.WhenTrue(compile(holds.expression(), block.job(compilation.newRegion()))),
        optional(holds.duration(), block));
  }

  Node every(Ast.Every every, LexicalScope block, HandledJumps seen) {
    boolean sequential = every.flavor() == Flavor.PIPE || every.flavor() == Flavor.SEMICOLON;
    return new Every(
        every.span(),
        every.flavor(),
        compile(every.period(), block),
        sequential
            ? compilation.compile(every.body(), block, seen.inLoop())
            : compilation.statements.job(every.body(), block));
  }
}
