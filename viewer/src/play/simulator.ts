// SPDX-License-Identifier: Apache-2.0
// A simulator in a Worker of its own, asked by promises.
import type { Answer, Calls, Question } from './module';
import SimulatorWorker from './worker?worker&inline';

export class RemoteSimulator {
  private readonly worker = new SimulatorWorker();
  private readonly waiting = new Map<number, { resolve(result: unknown): void; reject(error: Error): void }>();
  private asked = 0;

  constructor(module: WebAssembly.Module) {
    this.worker.addEventListener('message', ({ data }: MessageEvent<Answer>) => {
      const who = this.waiting.get(data.id);
      this.waiting.delete(data.id);
      if ('error' in data) who?.reject(new Error(data.error));
      else who?.resolve(data.result);
    });
    this.post({ module });
  }

  ask<K extends keyof Calls>(call: K, ...args: Parameters<Calls[K]>): Promise<ReturnType<Calls[K]>> {
    const id = this.asked++;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve: (result) => resolve(result as ReturnType<Calls[K]>), reject });
      this.post({ id, call, args });
    });
  }

  end(): void {
    this.worker.terminate();
  }

  private post(question: Question): void {
    this.worker.postMessage(question);
  }
}
