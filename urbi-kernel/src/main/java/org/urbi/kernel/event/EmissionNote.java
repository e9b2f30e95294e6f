package org.urbi.kernel.event;

/** What a subscription needs again at the end of an {@link Emission} that has begun for it. */
public sealed interface EmissionNote
    permits Emission, AtEvent.Waiting, FunctionHandler.Matched, WaitUntil.ForEvent {}
