/** What a lobby may have at a time, and what it has. */
package org.urbi.kernel.budget;
